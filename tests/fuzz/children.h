// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// For readers that do part of their work in a copy of this process (child_process.h).
#pragma once

namespace girdle::fuzz {

/// From now on a child that crashes ends at once, and the reader has to answer it. A child would
/// otherwise look for the cause, because it inherits how libFuzzer answers signals.
void LetChildrenCrash();

}  // namespace girdle::fuzz

// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The controllers of a process. Each belongs to one plugin instance in one mjData.
///
/// MuJoCo stores one integer for each instance in mjData. Python's pickle copies this integer with
/// all other bytes into another mjData or another process, where a pointer would be invalid. The
/// integer is therefore a ticket. A ticket leads to a controller only in the process that issued
/// it, and only from the mjData that the controller belongs to.
///
/// Every step of every thread calls Find, so Find takes no lock. Add and Remove take one.
#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "plugin/rhythm_controller.h"

namespace girdle {

class ControllerRegistry {
 public:
  ControllerRegistry() noexcept;
  ControllerRegistry(const ControllerRegistry&) = delete;
  ControllerRegistry& operator=(const ControllerRegistry&) = delete;
  ~ControllerRegistry();

  /// Stores a controller and returns its ticket, which is never 0. If this mjData and instance
  /// already have a controller, that one is deleted. Throws std::bad_alloc.
  std::uintptr_t Add(std::unique_ptr<RhythmController> controller, const mjData* data,
                     int instance);

  /// Returns the controller of this mjData and instance, or null if `ticket` does not lead to it.
  /// The pointer is valid until Add or Remove is called for the same mjData and instance.
  [[nodiscard]] RhythmController* Find(std::uintptr_t ticket, const mjData* data,
                                       int instance) const noexcept;

  /// Returns the ticket of this mjData and instance, or 0 if they have no controller.
  [[nodiscard]] std::uintptr_t TicketOf(const mjData* data, int instance) noexcept;

  /// Deletes the controller of this mjData and instance, if there is one.
  void Remove(const mjData* data, int instance) noexcept;

 private:
  // The entry that a ticket leads to. Places are reused, tickets are not.
  struct Place {
    std::atomic<std::uintptr_t> ticket{0};  ///< 0: free
    std::atomic<const mjData*> data{nullptr};
    std::atomic<int> instance{0};
    std::atomic<RhythmController*> controller{nullptr};
    Place* next_free = nullptr;
    std::size_t number = 0;
  };

  // The low bits of a ticket are the number of its place, from 1 on.
  static constexpr int kPlaceBits = 24;
  // Block k has kFirstBlock << k places and never moves.
  static constexpr std::size_t kFirstBlock = 64;
  static constexpr std::size_t kBlockCount = 18;
  static constexpr std::size_t kMostPlaces = (kFirstBlock << kBlockCount) - kFirstBlock;
  static_assert(kMostPlaces < std::size_t{1} << kPlaceBits);

  /// Returns the number of the first place of a block, kFirstBlock (2^block - 1).
  [[nodiscard]] static constexpr std::size_t FirstOf(std::size_t block) noexcept {
    return (kFirstBlock << block) - kFirstBlock;
  }
  /// Returns the block of a place.
  [[nodiscard]] static std::size_t BlockOf(std::size_t number) noexcept;
  /// Returns the place of a ticket, or null if there is no such place.
  [[nodiscard]] Place* PlaceOf(std::uintptr_t ticket) const noexcept;
  [[nodiscard]] Place& TakePlace();

  std::array<std::atomic<Place*>, kBlockCount> blocks_{};

  std::mutex mutex_;  ///< guards the members below and every change
  std::map<std::pair<const mjData*, int>, std::uintptr_t> tickets_;
  Place* first_free_ = nullptr;
  std::size_t place_count_ = 0;  ///< number of places that were ever used
  std::uintptr_t next_;          ///< the high bits of the next ticket
};

}  // namespace girdle

// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "plugin/controller_registry.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <set>
#include <vector>

#include "plugin/engine_layout.h"
#include "plugin/engine_views.h"
#include "simulation/plugin_fixture.h"

namespace girdle::controller_registry_test {
namespace {

class ControllerRegistryTest : public PluginTest {
 protected:
  [[nodiscard]] std::unique_ptr<RhythmController> Made() const {
    return std::make_unique<RhythmController>(ViewOf(*model_, *FindEngineLayout(mj_version())), 0,
                                              ParseRhythmConfig({}));
  }

  // A registry never looks into an mjData: any address will do.
  [[nodiscard]] const mjData* DataAt(std::size_t k) const {
    return reinterpret_cast<const mjData*>(&addresses_.at(k));
  }

  ControllerRegistry registry_;

 private:
  std::array<char, 1000> addresses_{};
};

TEST_F(ControllerRegistryTest, ATicketLeadsToItsControllerFromItsOwnDataAlone) {
  auto controller = Made();
  const RhythmController* const made = controller.get();
  const std::uintptr_t ticket = registry_.Add(std::move(controller), DataAt(0), 3);
  EXPECT_EQ(registry_.Find(ticket, DataAt(0), 3), made);
  EXPECT_EQ(registry_.Find(ticket, DataAt(1), 3), nullptr) << "of another mjData";
  EXPECT_EQ(registry_.Find(ticket, DataAt(0), 2), nullptr) << "of another instance";
  EXPECT_EQ(registry_.TicketOf(DataAt(0), 3), ticket);
  EXPECT_EQ(registry_.TicketOf(DataAt(1), 3), 0U);
  registry_.Remove(DataAt(0), 3);
}

TEST_F(ControllerRegistryTest, WhatIsNoTicketLeadsNowhere) {
  const std::uintptr_t ticket = registry_.Add(Made(), DataAt(0), 0);
  constexpr std::uintptr_t kPointer = 0x7f1234567890;
  for (const std::uintptr_t other :
       {std::uintptr_t{0}, std::uintptr_t{1}, ticket - 1, ticket + 1, ticket ^ (ticket << 24),
        kPointer, std::numeric_limits<std::uintptr_t>::max()}) {
    EXPECT_EQ(registry_.Find(other, DataAt(0), 0), nullptr) << other;
  }
  registry_.Remove(DataAt(0), 0);
}

TEST_F(ControllerRegistryTest, ATicketIsNeverGivenOutTwice) {
  std::set<std::uintptr_t> tickets;
  for (int round = 0; round < 5; ++round) {
    const std::uintptr_t ticket = registry_.Add(Made(), DataAt(0), 0);
    EXPECT_TRUE(tickets.insert(ticket).second);
    registry_.Remove(DataAt(0), 0);
    EXPECT_EQ(registry_.Find(ticket, DataAt(0), 0), nullptr) << "after it was removed";
    EXPECT_EQ(registry_.TicketOf(DataAt(0), 0), 0U);
  }
  // What was given out before leads nowhere, although its place is taken again.
  const std::uintptr_t last = registry_.Add(Made(), DataAt(0), 0);
  for (const std::uintptr_t ticket : tickets) {
    EXPECT_EQ(registry_.Find(ticket, DataAt(0), 0), nullptr);
  }
  EXPECT_NE(registry_.Find(last, DataAt(0), 0), nullptr);
  registry_.Remove(DataAt(0), 0);
}

TEST_F(ControllerRegistryTest, ASecondControllerOfOneInstanceTakesThePlaceOfTheFirst) {
  const std::uintptr_t first = registry_.Add(Made(), DataAt(0), 0);
  const std::uintptr_t second = registry_.Add(Made(), DataAt(0), 0);
  EXPECT_EQ(registry_.Find(first, DataAt(0), 0), nullptr);
  EXPECT_NE(registry_.Find(second, DataAt(0), 0), nullptr);
  registry_.Remove(DataAt(0), 0);
  registry_.Remove(DataAt(0), 0);  // there is none any more
}

// More than the first block of places holds.
TEST_F(ControllerRegistryTest, HundredsOfControllersKeepTheirTickets) {
  constexpr std::size_t kMany = 300;
  std::vector<std::uintptr_t> tickets;
  std::vector<const RhythmController*> controllers;
  for (std::size_t k = 0; k < kMany; ++k) {
    auto controller = Made();
    controllers.push_back(controller.get());
    tickets.push_back(registry_.Add(std::move(controller), DataAt(k), 0));
  }
  for (std::size_t k = 0; k < kMany; k += 2) {
    registry_.Remove(DataAt(k), 0);
  }
  for (std::size_t k = 0; k < kMany; ++k) {
    EXPECT_EQ(registry_.Find(tickets[k], DataAt(k), 0), k % 2 == 0 ? nullptr : controllers[k]) << k;
  }
  for (std::size_t k = 1; k < kMany; k += 2) {
    registry_.Remove(DataAt(k), 0);
  }
}

}  // namespace
}  // namespace girdle::controller_registry_test

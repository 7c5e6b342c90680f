// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "plugin/controller_registry.h"

#include <chrono>
#include <new>

namespace girdle {

// Tickets begin at the time of the process's start. Another process has other tickets, so that
// tickets in its mjData are unknown here.
ControllerRegistry::ControllerRegistry() noexcept
    : next_(static_cast<std::uintptr_t>(
          std::chrono::system_clock::now().time_since_epoch().count())) {}

ControllerRegistry::~ControllerRegistry() {
  for (const auto& [owner, ticket] : tickets_) {
    if (const Place* const place = PlaceOf(ticket); place != nullptr) {
      delete place->controller.load(std::memory_order_relaxed);
    }
  }
  for (const std::atomic<Place*>& block : blocks_) {
    delete[] block.load(std::memory_order_relaxed);
  }
}

std::size_t ControllerRegistry::BlockOf(std::size_t number) noexcept {
  std::size_t block = 0;
  while (block + 1 < kBlockCount && number >= FirstOf(block + 1)) {
    ++block;
  }
  return block;
}

ControllerRegistry::Place* ControllerRegistry::PlaceOf(std::uintptr_t ticket) const noexcept {
  const std::size_t number = (ticket & ((std::uintptr_t{1} << kPlaceBits) - 1)) - 1;
  if (number >= kMostPlaces) {
    return nullptr;
  }
  const std::size_t block = BlockOf(number);
  Place* const places = blocks_[block].load(std::memory_order_acquire);
  return places == nullptr ? nullptr : places + (number - FirstOf(block));
}

ControllerRegistry::Place& ControllerRegistry::TakePlace() {
  if (first_free_ != nullptr) {
    return *std::exchange(first_free_, first_free_->next_free);
  }
  if (place_count_ == kMostPlaces) {
    throw std::bad_alloc();
  }
  const std::size_t number = place_count_ + 1;
  if (PlaceOf(number) == nullptr) {
    const std::size_t block = BlockOf(place_count_);
    blocks_[block].store(new Place[kFirstBlock << block], std::memory_order_release);
  }
  ++place_count_;
  Place& place = *PlaceOf(number);
  place.number = number;
  return place;
}

std::uintptr_t ControllerRegistry::Add(std::unique_ptr<RhythmController> controller,
                                       const mjData* data, int instance) {
  Remove(data, instance);
  const std::lock_guard lock(mutex_);
  std::uintptr_t& ticket = tickets_[{data, instance}];
  Place& place = TakePlace();
  ticket = (next_++ << kPlaceBits) | place.number;
  place.data.store(data, std::memory_order_relaxed);
  place.instance.store(instance, std::memory_order_relaxed);
  place.controller.store(controller.release(), std::memory_order_relaxed);
  place.ticket.store(ticket, std::memory_order_release);
  return ticket;
}

RhythmController* ControllerRegistry::Find(std::uintptr_t ticket, const mjData* data,
                                           int instance) const noexcept {
  const Place* const place = PlaceOf(ticket);
  if (place == nullptr || place->ticket.load(std::memory_order_acquire) != ticket ||
      place->data.load(std::memory_order_relaxed) != data ||
      place->instance.load(std::memory_order_relaxed) != instance) {
    return nullptr;
  }
  return place->controller.load(std::memory_order_relaxed);
}

std::uintptr_t ControllerRegistry::TicketOf(const mjData* data, int instance) noexcept {
  const std::lock_guard lock(mutex_);
  const auto at = tickets_.find({data, instance});
  return at == tickets_.end() ? 0 : at->second;
}

void ControllerRegistry::Remove(const mjData* data, int instance) noexcept {
  const std::lock_guard lock(mutex_);
  const auto at = tickets_.find({data, instance});
  if (at == tickets_.end()) {
    return;
  }
  Place* const place = PlaceOf(at->second);
  tickets_.erase(at);
  if (place != nullptr) {  // null if Add ran out of memory
    place->ticket.store(0, std::memory_order_release);
    delete place->controller.exchange(nullptr, std::memory_order_relaxed);
    place->next_free = std::exchange(first_free_, place);
  }
}

}  // namespace girdle

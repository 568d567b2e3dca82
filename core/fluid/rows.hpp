#pragma once
// New rows of a world's fluids: each has its slot, its number, and the step in which it came.
#include "world.hpp"

namespace evil::fluid {

template <class Row> Row& made(Row& row) { return row; }
template <class Row> Row& made(std::unique_ptr<Row>& row) { return *row; }

template <class Row> std::uint32_t add_row(World& world, Slots& slots, std::vector<Row>& rows, Row row) {
    const std::uint32_t slot = slots.take();
    if (slot >= rows.size()) rows.resize(slot + 1);
    made(row).serial = world.fluids.next_serial++;
    made(row).born = world.steps;
    rows[slot] = std::move(row);
    return slot;
}

} // namespace evil::fluid

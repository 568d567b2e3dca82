#pragma once
// What a smoke needs within a step, and would find again if it were lost.
#include "fluid/smoke.hpp"
#include "fluid/stam.hpp"

namespace evil::fluid {

struct Scratch {
    StamScratch stam;
};

} // namespace evil::fluid

#pragma once
#include "bind/handle.hpp"

namespace evil::bind {

using Words = nb::typed<nb::dict, nb::str, nb::any>;
Traits to_traits(nb::dict words, const char* owner, Traits traits = {}); // those of a dict, where it has not None
void bind_traits(nb::class_<BodyHandle>& c);
void bind_traits(nb::class_<ShapeHandle>& c);

} // namespace evil::bind

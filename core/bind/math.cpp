// Elementary functions for Python: what must agree with the core to the last bit uses these.
#include "bind/module.hpp"
#include "math/functions.hpp"

namespace evil::bind {

void register_math(nb::module_& module) {
    module.def(
        "sincos",
        [](double angle) {
            SinCos f = sincos(angle);
            return nb::make_tuple(f.sin, f.cos);
        },
        nb::arg("angle"), nb::sig("def sincos(angle: float) -> tuple[float, float]"),
        "(sin, cos) of an angle in radians, rounded to 32 bits; the same bits on every machine.");
    module.def("atan2", &atan2, nb::arg("y"), nb::arg("x"), "Direction of (x, y) in radians, rounded to 32 bits.");
    module.def("exponential", &exponential, nb::arg("x"), "e to the power x, with the same bits on every machine.");
    module.def("logarithm", &logarithm, nb::arg("x"), "Natural logarithm, with the same bits on every machine.");
    module.def("power", &power, nb::arg("base"), nb::arg("exponent"),
               "base ** exponent for base >= 0, with the same bits on every machine.");
}

} // namespace evil::bind

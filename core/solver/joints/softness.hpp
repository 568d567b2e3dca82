#pragma once
// Springs and stiff holds as the solver's rows answer them.
#include "bodies.hpp"
#include "solver/joints/joint_blocks.hpp"

namespace evil {

// Catto, "Soft Constraints" (GDC 2011): a spring of that frequency and damping ratio, integrated implicitly over h.
inline Softness stiff_softness(float hertz, float damping_ratio, float h) {
    float omega = static_cast<float>(2.0 * kPi) * hertz;
    float a1 = 2.0f * damping_ratio + h * omega, a2 = h * omega * a1, a3 = 1.0f / (1.0f + a2);
    return {a2 * a3, (omega / a1) * a2 * a3, a3};
}

// The same for a spring that is meant to be seen swinging: k and c over the mass that it moves. Implicit integration
// takes energy away, h k / 2m of it a second; so slow springs pull by where they are (as symplectic Euler does, which
// keeps the energy), and only those too fast for that, by where they will be.
inline Softness spring_softness(float stiffness_by_mass, float damping_by_mass, float h) {
    float phase = h * std::sqrt(stiffness_by_mass); // radians of a swing in a substep
    float ahead = clamped((phase - 0.25f) * (1.0f / 0.75f), 1.0f);
    if (ahead < 0.0f) ahead = 0.0f;
    float a2 = h * (damping_by_mass + ahead * h * stiffness_by_mass), a3 = 1.0f / (1.0f + a2);
    return {a2 * a3, h * stiffness_by_mass * a3, a3};
}

} // namespace evil

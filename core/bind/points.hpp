#pragma once
// Questions about many points at once.
#include "bind/buffer.hpp"

namespace evil::bind {

using Answers = nb::typed<nb::list, nb::any>;

// What `answer` says of each point: points are a buffer of two columns, or anything that gives pairs.
template <class Answer> Answers ask_each(nb::handle points, const char* owner, Answer answer) {
    nb::list answers;
    const Buffer rows(points);
    if (rows && rows.dimensions() == 2) {
        if (rows.columns() != 2 || !(rows.real() || rows.whole()))
            raise(ErrorKind::argument, std::string(owner) + ": points must have two columns of numbers; got " +
                                           rows.shape() + " of '" + rows.format() + "'");
        for (Py_ssize_t i = 0; i < rows.rows(); ++i)
            answers.append(answer(Vec2{static_cast<float>(rows.number(i, 0)), static_cast<float>(rows.number(i, 1))}));
        return nb::borrow<Answers>(answers);
    }
    if (is_text(points) || !nb::hasattr(points, "__iter__"))
        raise(ErrorKind::argument_type, std::string(owner) + ": points must be a point, a list of points or an array");
    for (nb::handle point : nb::iter(points)) answers.append(answer(to_vec2(point, owner, "points")));
    return nb::borrow<Answers>(answers);
}

} // namespace evil::bind

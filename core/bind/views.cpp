// Views: the world's arrays as Python buffers, without a copy. A view keeps its storage alive.
#include "bind/views.hpp"

namespace evil::bind {
namespace {

int get_buffer(PyObject* self, Py_buffer* buffer, int flags) {
    View* view = nb::inst_ptr<View>(self);
    if (flags & PyBUF_WRITABLE) {
        PyErr_SetString(PyExc_BufferError, "the world's arrays are read-only; write through the bodies");
        buffer->obj = nullptr;
        return -1;
    }
    buffer->buf = const_cast<float*>(view->data);
    buffer->obj = self;
    Py_INCREF(self);
    buffer->len = static_cast<Py_ssize_t>(view->shape[0] * view->columns * static_cast<Py_ssize_t>(sizeof(float)));
    buffer->itemsize = sizeof(float);
    buffer->readonly = 1;
    buffer->ndim = view->columns == 1 ? 1 : 2;
    buffer->format = const_cast<char*>("f");
    buffer->shape = view->shape;
    buffer->strides = view->strides;
    buffer->suboffsets = nullptr;
    buffer->internal = nullptr;
    return 0;
}

PyType_Slot slots[] = {{Py_bf_getbuffer, reinterpret_cast<void*>(get_buffer)}, {0, nullptr}};

nb::object item(const View& view, Py_ssize_t i) {
    if (i < 0) i += view.shape[0];
    if (i < 0 || i >= view.shape[0]) throw nb::index_error("there is no such slot");
    const float* at = view.data + i * view.columns;
    if (view.columns == 1) return nb::float_(double(at[0]));
    if (view.columns == 2) return from_vec2({at[0], at[1]});
    nb::list values;
    for (Py_ssize_t k = 0; k < view.columns; ++k) values.append(double(at[k]));
    return nb::tuple(values);
}

} // namespace

void register_views(nb::module_& module) {
    nb::class_<View> c(module, "View", nb::type_slots(slots),
                       "One of the world's arrays, a row for each slot: a read-only float32 buffer that is not copied, "
                       "refreshed after each step. `numpy.asarray(view)` works; `view[slot]` gives one value.");
    c.def("__len__", [](const View& view) { return view.shape[0]; });
    c.def("__getitem__", item);
}

} // namespace evil::bind

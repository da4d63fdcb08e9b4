/* The floor of decoding: a STATUS packet to a Python tuple, as a compiled extension does it (PROTOCOLS 1.3, 1.7). */
#define PY_SSIZE_T_CLEAN
#include <Python.h>
#include <stdint.h>

static uint16_t crc_table[256];

static uint64_t get(const uint8_t *at, int size) {
    uint64_t value = 0;
    for (int i = 0; i < size; i++) value = value << 8 | at[i];
    return value;
}

static PyObject *decode(PyObject *self, PyObject *packet) {
    (void)self;
    if (!PyBytes_Check(packet) || PyBytes_GET_SIZE(packet) != 33) Py_RETURN_NONE;
    const uint8_t *data = (const uint8_t *)PyBytes_AS_STRING(packet);
    uint16_t crc = 0xFFFF;
    for (int i = 0; i < 31; i++) crc = (uint16_t)(crc << 8 ^ crc_table[(crc >> 8 ^ data[i]) & 0xFF]);
    if (data[0] != 5 || crc != get(data + 31, 2)) Py_RETURN_NONE;
    return Py_BuildValue("KKKKKKK", get(data + 1, 4), get(data + 5, 8), get(data + 13, 2), get(data + 15, 4), get(data + 19, 4),
                         get(data + 23, 6), get(data + 29, 2));
}

static PyMethodDef methods[] = {{"decode", decode, METH_O, "Return the seven numbers of a STATUS packet."}, {NULL, NULL, 0, NULL}};
static struct PyModuleDef module = {.m_base = PyModuleDef_HEAD_INIT, .m_name = "cdecode", .m_size = -1, .m_methods = methods};

PyMODINIT_FUNC PyInit_cdecode(void) {
    for (int i = 0; i < 256; i++) {
        uint16_t crc = (uint16_t)(i << 8);
        for (int bit = 0; bit < 8; bit++) crc = (uint16_t)(crc & 0x8000 ? crc << 1 ^ 0x1021 : crc << 1);
        crc_table[i] = crc;
    }
    return PyModule_Create(&module);
}

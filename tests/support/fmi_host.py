# SPDX-License-Identifier: Apache-2.0
"""Small importing program for functional mock-up units, through ctypes: FMI 2.0 and 3.0."""

from __future__ import annotations

import ctypes as ct
import xml.etree.ElementTree as ET
import zipfile
from pathlib import Path

import numpy as np

DOUBLES, WORDS, SIZE = ct.POINTER(ct.c_double), ct.POINTER(ct.c_uint32), ct.c_size_t
LIBC = ct.CDLL(None)
LIBC.calloc.restype = ct.c_void_p
LOGGER2 = ct.CFUNCTYPE(None, ct.c_void_p, ct.c_char_p, ct.c_int, ct.c_char_p, ct.c_char_p, ct.c_char_p)
LOGGER3 = ct.CFUNCTYPE(None, ct.c_void_p, ct.c_int, ct.c_char_p, ct.c_char_p)


class Callbacks(ct.Structure):
    """Functions that FMI 2.0 passes to an instance."""

    _fields_ = [
        (name, ct.c_void_p) for name in ("logger", "allocate", "release", "step_finished", "environment")
    ]


class Unit:
    """An unpacked unit: description, library, and its functions without the prefix."""

    def __init__(self, file, folder):
        with zipfile.ZipFile(file) as archive:
            archive.extractall(folder)
        self.root = ET.parse(Path(folder, "modelDescription.xml")).getroot()
        self.version = int(self.root.get("fmiVersion")[0])
        self.token = self.root.get("guid") or self.root.get("instantiationToken")
        co = self.root.find("CoSimulation")
        place = {2: "linux64", 3: "x86_64-linux"}[self.version]
        self.library = Path(folder, "binaries", place, co.get("modelIdentifier") + ".so")
        self.functions = ct.CDLL(str(self.library))
        self.variables = {}
        for each in self.root.find("ModelVariables"):
            self.variables[each.get("name")] = each
        self.messages, self.loggers = [], []

    def references(self, causality):
        """Value references of all variables of a causality, in order of the description."""
        found = [v for v in self.variables.values() if v.get("causality") == causality]
        return [int(v.get("valueReference")) for v in found]

    def names(self, causality):
        """Names of all variables of a causality."""
        return [name for name, v in self.variables.items() if v.get("causality") == causality]

    def function(self, name, restype=ct.c_int):
        """A function of the library."""
        found = getattr(self.functions, f"fmi{self.version}{name}")
        found.restype = restype
        return found

    def instance(self, token=None, exchange=False):
        """New instance; None if it is refused."""
        token = (token or self.token).encode()
        if self.version == 2:
            logger = LOGGER2(
                lambda e, name, status, category, form, text: self.messages.append(text.decode())
            )
            pointers = [ct.cast(p, ct.c_void_p) for p in (logger, LIBC.calloc, LIBC.free)]
            callbacks = Callbacks(*pointers, None, None)
            args = (b"one", 0 if exchange else 1, token, b"", ct.byref(callbacks), 0, 0)
            made = self.function("Instantiate", ct.c_void_p)(*args)
        else:
            logger = LOGGER3(lambda e, status, category, text: self.messages.append(text.decode()))
            no = ct.c_bool(False)
            if exchange:
                args = (b"one", token, b"", no, no, None, logger)
                made = self.function("InstantiateModelExchange", ct.c_void_p)(*args)
            else:
                args = (b"one", token, b"", no, no, no, no, None, SIZE(0), None, logger, None)
                made = self.function("InstantiateCoSimulation", ct.c_void_p)(*args)
        self.loggers.append(logger)  # instances refer to it
        return Instance(self, made, exchange) if made else None


class Instance:
    """An instance of a unit."""

    def __init__(self, unit, pointer, exchange):
        self.unit, self.pointer, self.exchange = unit, ct.c_void_p(pointer), exchange

    def call(self, name, *args):
        """Status of a function."""
        return self.unit.function(name)(self.pointer, *args)

    def free(self):
        """Free the instance."""
        self.unit.function("FreeInstance", None)(self.pointer)

    def initialise(self, start=0.0, **values):
        """Initialise with start values by name."""
        zero = ct.c_double(0.0)
        times = (ct.c_double(start), ct.c_int(0), zero)
        if self.unit.version == 2:
            assert self.call("SetupExperiment", 0, zero, *times) == 0
            assert self.call("EnterInitializationMode") == 0
        else:
            assert self.call("EnterInitializationMode", ct.c_bool(False), zero, *times) == 0
        if values:
            assert self.set(values) == 0
        assert self.call("ExitInitializationMode") == 0
        if self.exchange:
            assert self.call("EnterContinuousTimeMode") == 0
        return self

    def get(self, references):
        """Values of variables, shape (n,)."""
        n = len(references)
        out = np.full(n, np.nan)
        args = ((ct.c_uint32 * n)(*references), SIZE(n), out.ctypes.data_as(DOUBLES))
        status = (
            self.call("GetReal", *args) if self.unit.version == 2 else self.call("GetFloat64", *args, SIZE(n))
        )
        assert status == 0, self.unit.messages
        return out

    def set(self, values):
        """Set variables by name; returns the status."""
        references = [int(self.unit.variables[name].get("valueReference")) for name in values]
        n = len(references)
        numbers = (ct.c_double * n)(*values.values())
        args = ((ct.c_uint32 * n)(*references), SIZE(n), numbers)
        return (
            self.call("SetReal", *args) if self.unit.version == 2 else self.call("SetFloat64", *args, SIZE(n))
        )

    def step(self, t, size):
        """One communication step; returns the status."""
        args = (ct.c_double(t), ct.c_double(size))
        if self.unit.version == 2:
            return self.call("DoStep", *args, 1)
        flags = [ct.c_bool(True) for _ in range(3)]
        last = ct.c_double()
        status = self.call("DoStep", *args, ct.c_bool(True), *(ct.byref(f) for f in flags), ct.byref(last))
        assert not any(flag.value for flag in flags)
        return status

    def steps(self, first, n, size, references):
        """Values after each of n communication steps, shape (n, number of references)."""
        rows = []
        for k in range(first, first + n):
            assert self.step(k * size, size) == 0, self.unit.messages
            rows.append(self.get(references))
        return np.array(rows)

    # ------------------------------------------------------------------------------------------------ states

    def _word(self, name):
        return name.replace("FMUState", "FMUstate" if self.unit.version == 2 else "FMUState")

    def keep(self):
        """State of the unit."""
        state = ct.c_void_p()
        assert self.call(self._word("GetFMUState"), ct.byref(state)) == 0
        return state

    def restore(self, state):
        """Restore a state; returns the status."""
        return self.call(self._word("SetFMUState"), state)

    def drop(self, state):
        """Free a state."""
        assert self.call(self._word("FreeFMUState"), ct.byref(state)) == 0
        assert not state.value

    def serialise(self, state):
        """Bytes of a state."""
        size = ct.c_size_t()
        assert self.call(self._word("SerializedFMUStateSize"), state, ct.byref(size)) == 0
        data = ct.create_string_buffer(size.value)
        assert self.call(self._word("SerializeFMUState"), state, data, size) == 0
        return data.raw

    def deserialise(self, data):
        """Status, and the state of bytes."""
        state = ct.c_void_p()
        word = "DeSerializeFMUstate" if self.unit.version == 2 else "DeserializeFMUState"
        return self.call(word, data, SIZE(len(data)), ct.byref(state)), state

    # ---------------------------------------------------------------------------------------- model exchange

    def vector(self, name, n):
        """Result of a function that fills n numbers."""
        out = np.full(n, np.nan)
        assert self.call(name, out.ctypes.data_as(DOUBLES), SIZE(n)) == 0, self.unit.messages
        return out

    def slopes(self, t, x):
        """Derivatives of the states at a time."""
        assert self.call("SetTime", ct.c_double(t)) == 0
        x = np.ascontiguousarray(x)
        assert self.call("SetContinuousStates", x.ctypes.data_as(DOUBLES), SIZE(len(x))) == 0
        name = "GetDerivatives" if self.unit.version == 2 else "GetContinuousStateDerivatives"
        return self.vector(name, len(x))

    def directional(self, of, by, seed):
        """Directional derivative of variables by others, by value reference."""
        out = np.full(len(of), np.nan)
        seed = np.ascontiguousarray(seed, float)
        lists = ((ct.c_uint32 * len(of))(*of), SIZE(len(of)), (ct.c_uint32 * len(by))(*by), SIZE(len(by)))
        numbers = [(x.ctypes.data_as(DOUBLES), SIZE(len(x))) for x in (seed, out)]
        args = [n[0] for n in numbers] if self.unit.version == 2 else [x for n in numbers for x in n]
        assert self.call("GetDirectionalDerivative", *lists, *args) == 0, self.unit.messages
        return out

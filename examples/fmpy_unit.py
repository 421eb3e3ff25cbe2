"""One instance of a unit by FMPy, its variables by their names: what the examples for FMPy have in common."""

import shutil
from ctypes import byref, c_double, c_uint32

import fmpy
import numpy as np
from fmpy.fmi2 import FMU2Slave, fmi2CallbackFunctions, fmi2CallbackLoggerTYPE
from fmpy.logging import addLoggerProxy


class Unit:
    """An initialized instance of `archive` for co-simulation; `start` has its parameters and first inputs, enumerations by the names of their items."""

    def __init__(self, archive, start):
        self.messages = []
        description = fmpy.read_model_description(archive)
        self.variables = {v.name: v for v in description.modelVariables}
        self.folder = fmpy.extract(archive)
        identifier = description.coSimulation.modelIdentifier
        self.slave = FMU2Slave(guid=description.guid, unzipDirectory=self.folder, modelIdentifier=identifier, instanceName=identifier)
        # Without callbacks of their own the messages of a unit go to the console.
        self.callbacks = fmi2CallbackFunctions()
        self.callbacks.logger = fmi2CallbackLoggerTYPE(lambda e, name, status, category, text: self.messages.append(text.decode()))
        addLoggerProxy(byref(self.callbacks))
        self.slave.instantiate(callbacks=self.callbacks)
        self.slave.setupExperiment(startTime=0.0)
        self.set(start)
        self.slave.enterInitializationMode()
        self.slave.exitInitializationMode()

    def set(self, values):
        reals = {name: value for name, value in values.items() if self.variables[name].type == "Real"}
        self.slave.setReal([self.variables[name].valueReference for name in reals], list(reals.values()))
        for name in values.keys() - reals.keys():
            variable, value = self.variables[name], values[name]
            reference = [variable.valueReference]
            if variable.type == "String":
                self.slave.setString(reference, [value])
            elif variable.type == "Boolean":
                self.slave.setBoolean(reference, [value])
            else:
                items = {item.name: int(item.value) for item in variable.declaredType.items}
                self.slave.setInteger(reference, [items[value]])

    def get(self, *names):
        """One number for one name, a list for several."""
        values = self.slave.getReal([self.variables[name].valueReference for name in names])
        return values[0] if len(names) == 1 else values

    def derivatives(self, unknowns, knowns):
        """Matrix of the derivatives of the outputs `unknowns` by the inputs `knowns`, exact."""
        unknowns = [self.variables[name].valueReference for name in unknowns]
        columns = [self.slave.getDirectionalDerivative(unknowns, [self.variables[name].valueReference], [1.0]) for name in knowns]
        return np.array(columns).T

    def close(self):
        self.slave.freeInstance()
        shutil.rmtree(self.folder, ignore_errors=True)


class Port:
    """Some real variables of a unit in one call, without looking up their names each time."""

    def __init__(self, unit, names):
        self.slave, self.count = unit.slave, len(names)
        self.references = (c_uint32 * self.count)(*(unit.variables[name].valueReference for name in names))
        self.values = (c_double * self.count)()
        self.numbers = np.frombuffer(self.values)

    def set(self, values):
        self.numbers[:] = values
        self.slave.fmi2SetReal(self.slave.component, self.references, self.count, self.values)

    def get(self):
        self.slave.fmi2GetReal(self.slave.component, self.references, self.count, self.values)
        return self.numbers.copy()

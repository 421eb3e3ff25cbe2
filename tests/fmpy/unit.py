"""An instance of the FMU with variables by name and messages kept, for the checks beside."""

import shutil
from ctypes import byref

import fmpy
from fmpy.fmi2 import FMU2Slave, fmi2CallbackFunctions, fmi2CallbackLoggerTYPE
from fmpy.logging import addLoggerProxy


class Unit:
    """One instance, in initialization mode after the constructor."""

    def __init__(self, archive, start=None, name="wheel"):
        self.messages = []
        self.description = fmpy.read_model_description(archive)
        self.variables = {v.name: v for v in self.description.modelVariables}
        self.folder = fmpy.extract(archive)
        self.slave = FMU2Slave(
            guid=self.description.guid,
            unzipDirectory=self.folder,
            modelIdentifier=self.description.coSimulation.modelIdentifier,
            instanceName=name,
        )
        self.callbacks = fmi2CallbackFunctions()
        self.callbacks.logger = fmi2CallbackLoggerTYPE(self.log)
        # Formats the message: Python gets no variable arguments.
        addLoggerProxy(byref(self.callbacks))
        self.slave.instantiate(callbacks=self.callbacks)
        self.start(start or {})

    def log(self, environment, name, status, category, message):
        self.messages.append((name.decode(), status, category.decode(), message.decode()))

    def last(self):
        return self.messages[-1][3]

    def start(self, values):
        self.slave.setupExperiment(startTime=0.0)
        self.set(values)
        self.slave.enterInitializationMode()

    def ready(self):
        self.slave.exitInitializationMode()
        return self

    def set(self, values):
        for name, value in values.items():
            variable = self.variables[name]
            if variable.type == "Real":
                self.slave.setReal([variable.valueReference], [value])
            elif variable.type == "String":
                self.slave.setString([variable.valueReference], [value])
            elif variable.type == "Boolean":
                self.slave.setBoolean([variable.valueReference], [value])
            else:
                self.slave.setInteger([variable.valueReference], [value])

    def get(self, name):
        variable = self.variables[name]
        if variable.type == "Real":
            return self.slave.getReal([variable.valueReference])[0]
        if variable.type == "String":
            return self.slave.getString([variable.valueReference])[0].decode()
        return self.slave.getInteger([variable.valueReference])[0]

    def outputs(self):
        """All real outputs, for comparison bit for bit."""
        outputs = [v for v in self.description.modelVariables if v.causality == "output"]
        reals = [v.valueReference for v in outputs if v.type == "Real"]
        return tuple(self.slave.getReal(reals))

    def step(self, time, step):
        self.slave.doStep(currentCommunicationPoint=time, communicationStepSize=step)

    def close(self):
        self.slave.freeInstance()
        shutil.rmtree(self.folder, ignore_errors=True)

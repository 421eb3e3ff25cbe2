"""FMPy, for model exchange: forces at the inputs set last, without a step."""

import shutil

import fmpy
from fmpy.fmi2 import FMU2Model

import client

archive, names, positions, answers = client.arguments()
description = fmpy.read_model_description(archive)
references = {v.name: v.valueReference for v in description.modelVariables}
folder = fmpy.extract(archive)
model = FMU2Model(
    guid=description.guid, unzipDirectory=folder, instanceName="wheel",
    modelIdentifier=description.modelExchange.modelIdentifier,
)  # fmt: skip
model.instantiate()
model.setupExperiment(startTime=0.0)
model.enterInitializationMode()
model.exitInitializationMode()
model.enterContinuousTimeMode()
rows = []
for position in positions:
    model.setReal([references[name] for name in names], position)
    rows.append(model.getReal([references[name] for name in client.OUTPUTS]))
model.terminate()
model.freeInstance()
shutil.rmtree(folder)
client.write(answers, rows)

"""ecos: a fixed step, inputs set between steps."""

from ecospy.EcosSimulation import EcosSimulation
from ecospy.EcosSimulationStructure import EcosSimulationStructure

import client

archive, names, positions, answers = client.arguments()
rows = []
with EcosSimulationStructure() as structure:
    structure.add_model("wheel", archive)
    with EcosSimulation(structure=structure, step_size=client.STEP) as simulation:
        assert simulation.init()
        for position in positions:
            for name, value in zip(names, position):
                simulation.set_real(f"wheel::{name}", value)
            simulation.step()
            rows.append([simulation.get_real(f"wheel::{name}") for name in client.OUTPUTS])
        simulation.terminate()
client.write(answers, rows)

"""libcosim, the co-simulation engine of the Open Simulation Platform: a fixed step, inputs by override."""

from libcosimpy.CosimExecution import CosimExecution
from libcosimpy.CosimLogging import CosimLogLevel, log_output_level
from libcosimpy.CosimManipulator import CosimManipulator
from libcosimpy.CosimObserver import CosimObserver
from libcosimpy.CosimSlave import CosimLocalSlave

import client

archive, names, positions, answers = client.arguments()
log_output_level(CosimLogLevel.ERROR)
# Nanoseconds.
execution = CosimExecution.from_step_size(step_size=round(1e9 * client.STEP))
unit = CosimLocalSlave(fmu_path=archive, instance_name="wheel")
index = execution.add_local_slave(unit)
observer = CosimObserver.create_last_value()
override = CosimManipulator.create_override()
assert execution.add_observer(observer) and execution.add_manipulator(override)
references = {v.name.decode(): v.reference for v in execution.slave_variables(index)}
rows = []
for position in positions:
    assert override.slave_real_values(index, [references[name] for name in names], position)
    assert execution.step(1)
    rows.append(observer.last_real_values(index, [references[name] for name in client.OUTPUTS]))
client.write(answers, rows)

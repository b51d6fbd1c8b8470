"""The chain of chain.py in Exudyn: rigid bodies joined by 6x6 spring-dampers, generalised alpha.

    python peer_exudyn.py SEGMENTS END OUTPUTS

Prints one line of JSON. The element differs from BEAM in the moment it applies on J (O(1/N)).
"""

import json
import sys
import time

import exudyn as exu
import numpy as np
from exudyn.utilities import (
    MarkerBodyMass,
    MarkerBodyRigid,
    NodeRigidBodyEP,
    ObjectConnectorRigidBodySpringDamper,
    ObjectGround,
    ObjectRigidBody,
    LoadMassProportional,
    SensorBody,
)

import chain as c

segments, end, outputs = int(sys.argv[1]), float(sys.argv[2]), int(sys.argv[3])
length = c.LENGTH / segments
mass = c.DENSITY * c.AREA * length
inertia = [
    mass * (c.BREADTH**2 + c.HEIGHT**2) / 12.0,
    mass * (length**2 + c.HEIGHT**2) / 12.0,
    mass * (length**2 + c.BREADTH**2) / 12.0,
    0.0,
    0.0,
    0.0,
]
py = 12 * c.YOUNG * c.IZZ * c.SHEAR_RATIO / (c.SHEAR * c.AREA * length**2)
pz = 12 * c.YOUNG * c.IYY * c.SHEAR_RATIO / (c.SHEAR * c.AREA * length**2)
bend_y, bend_z = c.YOUNG * c.IZZ / (length * (1 + py)), c.YOUNG * c.IYY / (length * (1 + pz))
stiffness = np.diag(
    [c.YOUNG * c.AREA / length, 12 * bend_y / length**2, 12 * bend_z / length**2, c.SHEAR * c.IXX / length, (4 + pz) * bend_z, (4 + py) * bend_y]
)
stiffness[1, 5] = stiffness[5, 1] = -6 * bend_y / length
stiffness[2, 4] = stiffness[4, 2] = 6 * bend_z / length

container = exu.SystemContainer()
system = container.AddSystem()
ground = system.AddObject(ObjectGround())
before = system.AddMarker(MarkerBodyRigid(bodyNumber=ground, localPosition=[length, 0, 0]))
for i in range(1, segments + 1):
    node = system.AddNode(NodeRigidBodyEP(referenceCoordinates=[i * length, 0, 0, 1, 0, 0, 0]))
    body = system.AddObject(ObjectRigidBody(mass=mass, inertia=inertia, nodeNumber=node))
    here = system.AddMarker(MarkerBodyRigid(bodyNumber=body, localPosition=[0, 0, 0]))
    system.AddLoad(LoadMassProportional(markerNumber=system.AddMarker(MarkerBodyMass(bodyNumber=body)), loadVector=list(c.GRAVITY)))
    system.AddObject(
        ObjectConnectorRigidBodySpringDamper(markerNumbers=[before, here], stiffness=stiffness, damping=c.DAMPING * stiffness)
    )
    before = system.AddMarker(MarkerBodyRigid(bodyNumber=body, localPosition=[length, 0, 0]))
tip = system.AddSensor(SensorBody(bodyNumber=body, storeInternal=True, outputVariableType=exu.OutputVariableType.Position))
system.Assemble()
settings = exu.SimulationSettings()
settings.linearSolverType = exu.LinearSolverType.EigenSparse
settings.solutionSettings.writeSolutionToFile = False
settings.solutionSettings.sensorsWritePeriod = end / outputs
stepping = settings.timeIntegration
stepping.numberOfSteps, stepping.endTime = outputs, end
stepping.newton.useModifiedNewton = True
# The default tolerance is below the round-off of long chains.
stepping.newton.relativeTolerance = {True: 1e-5, False: 1e-4}[segments <= 100]
stepping.generalizedAlpha.spectralRadius = 0.7
stepping.verboseMode = 0
began = time.process_time()
system.SolveDynamic(settings)
solved = time.process_time() - began
position = np.asarray(system.GetSensorStoredData(tip))[-1]
print(json.dumps({"solve_s": solved, "tip_z": float(position[3])}))

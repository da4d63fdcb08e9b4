"""The kinematic plant: a whole fab of hoists that talks to the planner's rules directly, for speed.

It drives barcode by barcode with the vehicles' own acceleration and braking; who may go where is decided by the same functions
as in the controller (``planning.admission``, ``planning.buffers``). The byte-level plant of ``sim.world`` is the truth it is held
against. With numba installed it is compiled; without, the same functions run as they stand.
"""

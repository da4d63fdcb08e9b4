"""Pure algorithms over the plant: where a vehicle may go, how, and who. No clock, no I/O."""

"""The virtual plant and the virtual world: physical truth, simulated devices, virtual time. Sans-I/O."""

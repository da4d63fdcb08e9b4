"""ENIG: the controller's talk with AGVs, buffers and doors (PROTOCOLS section 3)."""

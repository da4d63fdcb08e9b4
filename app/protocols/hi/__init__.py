"""HI Inverter drives: several on one serial line under one master (PROTOCOLS section 2)."""

"""iTSC: the transport controller's talk with overhead hoists (PROTOCOLS section 1)."""

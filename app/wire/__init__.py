"""Tools for writing protocol tables: checksums, field layouts, hexadecimal text, names. Knows no protocol and no domain."""

// The keyword open must stand before other modifiers.
cylinder { 0, y, 1 pigment { rgb 1 } open }

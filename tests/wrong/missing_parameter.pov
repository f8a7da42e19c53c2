// A sphere without its radius.
sphere { <0, 0, 0> pigment { rgb <1, 0, 0> } }

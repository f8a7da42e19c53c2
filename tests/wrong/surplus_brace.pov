// One closing brace too many.
sphere { 0, 1 pigment { rgb <1, 0, 0> } } }
plane { y, 0 }

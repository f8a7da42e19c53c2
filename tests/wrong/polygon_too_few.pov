// A polygon of two points.
polygon { 2, <0, 0>, <1, 0> pigment { rgb 1 } }

// A name that was never declared.
sphere { <0, 0, 0>, Radius pigment { rgb 1 } }

// An angle beyond what a perspective camera can have.
camera { location -5 * z look_at 0 angle 200 }
sphere { 0, 1 pigment { rgb 1 } }

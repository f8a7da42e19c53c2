// CSG in CSG: a difference of an intersection and a union that itself holds a difference.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2.2, -6> look_at 0 angle 40 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

#declare Cutter = union {
  difference {
    cylinder { -2 * y, 2 * y, 0.7 }
    cylinder { -3 * y, 3 * y, 0.35 }
  }
  box { <-2, 0.5, -0.15>, <2, 2, 0.15> }
  pigment { rgb <0.9, 0.8, 0.3> }
}
difference {
  intersection {
    sphere { 0, 1.3 }
    box { -1, 1 pigment { rgb <0.3, 0.7, 0.3> } }
  }
  object { Cutter }
  object { Cutter rotate 90 * x pigment { rgb <0.3, 0.4, 0.9> } }
  rotate <25, 40, 0>
  pigment { rgb <0.8, 0.3, 0.2> }
}

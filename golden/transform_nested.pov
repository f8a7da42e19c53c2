// Transforms nested three deep, with a mirrored copy beside the original.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -9> look_at <0, 0.3, 0> angle 40 }
light_source { <-6, 9, -8> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

#declare Finger = union {
  cylinder { 0, <0, 1, 0>, 0.18 }
  sphere { <0, 1, 0>, 0.25 pigment { checker rgb 1 rgb <0.8, 0.2, 0.1> scale 0.2 } }
  scale <1, 0.8, 1>
}
#declare Hand = union {
  object { Finger rotate 40 * z }
  object { Finger }
  object { Finger rotate -40 * z scale <1, 0.7, 1> }
  box { <-0.5, -0.4, -0.2>, <0.5, 0.1, 0.2> }
  rotate <10, 25, 0>
  translate 0.6 * y
}
#declare Arm = union {
  object { Hand scale 1.1 }
  cylinder { <0, -1.4, 0>, <0, 0.3, 0>, 0.22 }
  rotate -20 * z
  translate 1.6 * x
  pigment { rgb <0.9, 0.7, 0.5> }
}
object { Arm }
object { Arm scale <-1, 1, 1> }

// cutaway_textures: the cut shows what the first solids are made of, mixed where they overlap.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

difference {
  union {
    sphere { -0.4 * x, 0.9 pigment { rgb <0.9, 0.2, 0.1> } }
    sphere { 0.5 * x, 0.8 pigment { rgb <0.1, 0.3, 0.9> } }
  }
  box { <-2, 0, -2>, <2, 2, 0> }
  cutaway_textures
  rotate <20, 25, 0>
  scale 1.3
}

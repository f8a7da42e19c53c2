// reflection: a mirror floor, a coloured mirror, and the variable kind with fresnel.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at <0, 0.4, 0> angle 40 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.3, 0.4, 0.6> }

plane { y, -0.6 pigment { checker rgb 0.8 rgb 0.2 } finish { reflection 0.4 } }
sphere { <-1.6, 0.3, 0>, 0.9 pigment { rgb 0.05 } finish { reflection { rgb <0.9, 0.7, 0.3> } } }
sphere { <0.4, 0.1, -1>, 0.7 pigment { rgb <0.6, 0.1, 0.1> } finish { reflection { 0.05, 0.8 falloff 2 } } }
sphere { <1.9, 0.5, 0.6>, 1 pigment { rgb <0.1, 0.3, 0.2> } interior { ior 1.5 }
  finish { reflection { 0, 1 fresnel } conserve_energy } }

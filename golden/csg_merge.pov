// merge beside union, both of glass: inner walls are gone in the merge.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.2, -7> look_at 0 angle 38 }
light_source { <-5, 7, -6> rgb 1 }
plane { y, -1.5 pigment { checker rgb 0.9 rgb <0.2, 0.3, 0.5> } }

#declare Glass = texture { pigment { rgbf <0.9, 0.95, 1, 0.8> } finish { phong 0.6 reflection 0.1 } }
#declare Left = sphere { -0.45 * x, 0.8 }
#declare Right = sphere { 0.45 * x, 0.8 }
union { object { Left } object { Right } translate <-1.4, 0, 0> texture { Glass } interior { ior 1.2 } }
merge { object { Left } object { Right } translate <1.4, 0, 0> texture { Glass } interior { ior 1.2 } }

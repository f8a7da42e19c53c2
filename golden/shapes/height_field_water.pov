// height_field: water_level cuts the valleys away; the solid is used in a difference; mirrored by scale.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0.5, 1.4, -1.3> look_at <0.5, 0.1, 0.5> angle 47 }
light_source { <-3, 4, -2> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }
#declare Land = height_field { function 20, 20 { 0.5 + 0.35 * sin(x * 9) * cos(y * 7) } water_level 0.45 pigment { rgb <0.4, 0.6, 0.3> } }
difference {
  object { Land scale <1, 0.6, 1> }
  cylinder { <0.65, -1, 0.3>, <0.65, 2, 0.3>, 0.22 pigment { rgb <0.8, 0.5, 0.3> } }
}
plane { y, 0.2 pigment { rgb <0.2, 0.3, 0.6> } }

// Mirrors that raise what they show to a power.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1.5, -6> look_at <0, 0.6, 0> angle 45 }
light_source { <-4, 6, -5> rgb 0.9 }
background { rgb <0.3, 0.45, 0.7> }
plane { y, 0 pigment { checker rgb <0.8, 0.75, 0.6> rgb <0.35, 0.3, 0.4> scale 0.7 translate 0.1 } }
#declare Mirror = finish { ambient 0 diffuse 0.2 reflection { 0.7 } };
sphere { <-1.5, 0.8, 0>, 0.7 pigment { rgb <0.8, 0.4, 0.3> } finish { Mirror reflection_exponent 0.6 } }
sphere { <0, 0.8, 0.4>, 0.7 pigment { rgb <0.4, 0.7, 0.3> } finish { Mirror } }
sphere { <1.5, 0.8, 0>, 0.7 pigment { rgb <0.3, 0.4, 0.8> } finish { Mirror reflection_exponent 2.5 } }

// Parts of solids that have no surface still count: nothing is inside of them, everything inside of their inverse.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 0, -9> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }
#default { pigment { rgb <0.8, 0.6, 0.4> } }
#declare Crooked = smooth_triangle { <-1, -1, 0>, -z, <1, -1, 0>, z, <0, 1, 0>, -z }
#declare Point = sphere { 0, 0 }
#declare Line = triangle { -1, 0, 1 }
intersection { sphere { 0, 0.8 } object { Crooked } translate <-2.5, 1.8, 0> }
intersection { sphere { 0, 0.8 } object { Point inverse } translate <-0.8, 1.8, 0> }
difference { sphere { 0, 0.8 } object { Point } translate <0.8, 1.8, 0> }
difference { sphere { 0, 0.8 } object { Line } translate <2.5, 1.8, 0> }
merge { sphere { 0, 0.8 } object { Crooked } translate <-2.5, 0, 0> }
intersection { sphere { 0, 0.8 } quadric { 0, 0, 0, -1 } pigment { rgb <0.4, 0.7, 0.9> } translate <-0.8, 0, 0> }
intersection { sphere { 0, 0.8 } quadric { 0, 0, 0, 1 } translate <0.8, 0, 0> }
difference { sphere { 0, 0.8 } intersection { box { 0, 1 } object { Line } } translate <2.5, 0, 0> }
sphere { 0, 0.8 clipped_by { object { Point } } translate <-2.5, -1.8, 0> }
sphere { 0, 0.8 clipped_by { object { Point inverse } } translate <-0.8, -1.8, 0> }
difference { sphere { 0, 0.8 } union { object { Line } object { Line } } translate <0.8, -1.8, 0> }
merge { sphere { 0, 0.8 } object { Point inverse } translate <2.5, -1.8, 0> }

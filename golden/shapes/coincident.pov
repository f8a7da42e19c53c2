// Coincident surfaces: of objects the one whose box begins first is seen, within a solid the last part.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

#declare Red = texture { pigment { rgb <0.8, 0.3, 0.2> } }
#declare Green = texture { pigment { rgb <0.3, 0.7, 0.3> } }
#declare Wide = box { <-0.8, -0.8, 0>, <0.8, 0.2, 1> }
#declare Tall = box { <-0.3, -0.5, 0>, <0.3, 0.8, 1> }
#declare Deep = union { object { Tall } box { <0.5, -0.2, -0.6>, <0.7, 0.6, 1> } split_union off }

object { Wide texture { Red } translate <-1.6, 1.2, 0> }
object { Tall texture { Green } translate <-1.6, 1.2, 0> }
object { Wide texture { Red } translate <1.6, 1.2, 0> }
object { Deep texture { Green } translate <1.6, 1.2, 0> }
union { object { Wide texture { Red } } object { Tall texture { Green } } split_union off translate <-1.6, -0.9, 0> }
merge { intersection { object { Wide texture { Red } } box { -1, 1 } } object { Tall texture { Green } } translate <1.6, -0.9, 0> }
plane { -z, -1 texture { pigment { rgb <0.3, 0.4, 0.9> } } }
box { <-3, -3, 1>, <3, -2, 1.5> texture { Red } }

// A height field is solid below its base, here turned up. What a solid shows of that depends on its box: without limit
// where the height field is a child itself (left), only for rays that meet the box of a union around it (middle), or of the
// height field that clips (right).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <6, 40, -20> look_at <0, 1, 0> right 24 * x up 18 * y }
light_source { <10, 30, -20>, 1 }
background { rgb <0, 0, .5> }
plane { y, -9 pigment { rgb .7 } }
#declare H = height_field { function 30, 30 { .9 * sin(pi * x) * sin(pi * y) } translate <-.5, 0, -.5> scale <5, 2, 5> rotate 180 * z };
#declare B = box { <-3, 1, -12>, <3, 3, 12> pigment { rgb y } };
difference { object { H pigment { rgb x } } object { B } translate -7 * x }
difference { union { object { H pigment { rgb x } } } object { B } }
intersection { box { <-2, -9, -9>, <2, 3, 9> clipped_by { object { H } } pigment { rgb <1, 1, 0> } } box { -9, 9 } translate 7 * x }

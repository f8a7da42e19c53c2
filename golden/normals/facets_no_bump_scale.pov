// facets: texture-level no_bump_scale does not concern them; both halves look alike.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 4*x up 3*y }
light_source { <3,5,-8> rgb 1 }
#declare Flag = texture { pigment { rgb 1 } normal { facets coords 0.4 scale 3 } no_bump_scale }
#declare Free = texture { pigment { rgb 1 } normal { facets coords 0.4 scale 3 } }
box { <-2,-1.4,0>, <0,1.4,1> texture { Flag } }
box { <0,-1.4,0>, <2,1.4,1> texture { Free } }

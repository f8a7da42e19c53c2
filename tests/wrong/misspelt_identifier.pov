// An identifier that is nearly the declared one.
#declare Base_Color = rgb <0.8, 0.3, 0.2>;
sphere { 0, 1 pigment { color Base_Colour } }

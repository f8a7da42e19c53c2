// A name with a letter missing where it is declared.
#version 3.7;
#declare Sze = 2;
box { -1, Size pigment { rgb 1 } }

// Identifiers tell capitals from small letters.
#declare height = 2;
box { 0, <1, Height, 1> }

// The scene itself asks to stop.
#declare Size = -1;
#if (Size < 0)
  #error "Size must not be negative"
#end

#fopen H "t.txt" write
#write (H, 1, ",", <1, 2, 3>, ",\"s\",", concat("2", "."), "\n", uint8 300 65, sint16le -3)
#fclose H
#fopen R "t.txt" read
#while (defined(R))
  #read (R, One, Two, Three)
#end
#ifdef (One) #warning concat("read ", str(One, 0, 1)) #end
#declare E = file_exists("t.txt");
#render "done\n"

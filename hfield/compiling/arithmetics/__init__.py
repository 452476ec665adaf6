"""The numbers of rings inside a loop: residues, elements of finite fields, integers of up to 64 bits."""

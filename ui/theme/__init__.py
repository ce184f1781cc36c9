"""How the editor looks: colour roles, the Qt palette made from them, a small stylesheet, icons."""


(* ---------------------------------------------------------------------------------------------- *)
(* Every associative ring with identity, commutative or not.                                      *)
(* ---------------------------------------------------------------------------------------------- *)

Module Presentations.
Import Ncring Ncring_tac.

Section Associative_rings.
Context {R : Type} `{laws : Ring R}.

Lemma product_nil : 0 == 0.
Proof. reflexivity. Qed.
Lemma product_cons : forall x l r y rest, l == r -> rest == 0 -> x * (l - r) * y + rest == 0.
Proof. intros x l r y rest -> ->. non_commutative_ring. Qed.
Lemma by_products : forall x y z, z == 0 -> x - y == z -> x == y.
Proof.
  intros x y z Z E. rewrite Z in E. transitivity (x - y + y); [non_commutative_ring |].
  rewrite E. non_commutative_ring.
Qed.
Local Notation nil := (product_nil).
Local Notation cons x y equation rest := (product_cons x _ _ y _ equation rest).
Ltac combine proof := refine (by_products _ _ _ proof _); non_commutative_ring.

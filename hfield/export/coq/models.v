
(* ---------------------------------------------------------------------------------------------- *)
(* Rings to compute in: where equality is decided, the truth of a statement at some values is      *)
(* computed; in a finite ring, at all values.                                                      *)
(* ---------------------------------------------------------------------------------------------- *)

Section Decided.
Context {R : Type} {operations : Operations R} {inverse : Inverse R}.
Variable eqb : R -> R -> bool.
Hypothesis eqb_is : forall x y, eqb x y = true <-> x = y.
Hypothesis inverse_is : forall x y : R, x * y = 1 -> x * inv x = 1.
Definition qeqb (p q : quaternion R) : bool :=
  eqb (re p) (re q) && eqb (im p) (im q) && eqb (jm p) (jm q) && eqb (km p) (km q).
Lemma qeqb_is : forall p q, qeqb p q = true <-> p = q.
Proof.
  intros [a b c d] [a' b' c' d']; unfold qeqb; cbn. rewrite 3!andb_true_iff, 4!eqb_is.
  split; [intros [[[-> ->] ->] ->]; reflexivity | intro E; injection E as -> -> -> ->; tauto].
Qed.
Fixpoint truth (A : algebra R) qs ss (f : formula) : bool :=
  match f with
  | Equal x y => eqb (scalar_value A qs ss x) (scalar_value A qs ss y)
  | Same p q => qeqb (quat_value A qs ss p) (quat_value A qs ss q)
  | Unit x => let x := scalar_value A qs ss x in eqb (x * inv x) 1
  | Not f => negb (truth A qs ss f)
  | And f g => if truth A qs ss f then truth A qs ss g else false
  | Or f g => if truth A qs ss f then true else truth A qs ss g
  | Imp f g => if truth A qs ss f then truth A qs ss g else true
  | Iff f g => Bool.eqb (truth A qs ss f) (truth A qs ss g)
  end.
Lemma truth_is : forall A qs ss f, truth A qs ss f = true <-> holds A qs ss f.
Proof.
  induction f; cbn [truth holds].
  - apply eqb_is.
  - apply qeqb_is.
  - rewrite eqb_is. split; [intro E; eexists; exact E | intros [y E]; exact (inverse_is _ _ E)].
  - rewrite <- IHf. destruct (truth A qs ss f); cbn; split; congruence.
  - rewrite <- IHf1, <- IHf2. destruct (truth A qs ss f1); intuition congruence.
  - rewrite <- IHf1, <- IHf2. destruct (truth A qs ss f1); intuition congruence.
  - rewrite <- IHf1, <- IHf2. destruct (truth A qs ss f1); intuition congruence.
  - rewrite <- IHf1, <- IHf2. destruct (truth A qs ss f1), (truth A qs ss f2); cbn; intuition congruence.
Qed.
Lemma imply_iff : forall A qs ss hs (P : Prop), hold_imply A qs ss hs P <->
  (forallb (truth A qs ss) hs = true -> P).
Proof.
  induction hs as [| h hs IH]; intro P; cbn [hold_imply forallb]; [intuition |].
  rewrite IH, <- (truth_is A qs ss h), andb_true_iff. intuition.
Qed.
Lemma at_values : forall T n (P : list T -> Prop) l, length l = n -> for_all n P -> P l.
Proof.
  induction n as [| n IH]; intros P [| x l] E F; try discriminate; [exact F |].
  exact (IH (fun l => P (List.cons x l)) l (eq_add_S _ _ E) (F x)).
Qed.
Lemma with_values : forall T n (P : list T -> Prop) l, length l = n -> P l -> there_are n P.
Proof.
  induction n as [| n IH]; intros P [| x l] E F; try discriminate; [exact F |].
  exists x. exact (IH (fun l => P (List.cons x l)) l (eq_add_S _ _ E) F).
Qed.

(* A counterexample, and an example. *)
Definition fails (st : statement) (qs : list (quaternion R)) (ss : list R) : bool :=
  let A := constants st ss in
  Nat.eqb (length qs) (quaternions st) && Nat.eqb (length ss) (scalars st) &&
  Nat.eqb (found_quaternions st) 0 && Nat.eqb (found_scalars st) 0 &&
  forallb (truth A qs ss) (given st) && negb (truth A qs ss (conclusion st)).
Theorem counterexample : forall st qs ss, fails st qs ss = true -> ~ says st.
Proof.
  intros st qs ss E S; unfold fails in E. repeat (apply andb_true_iff in E; destruct E as [E ?]).
  apply Nat.eqb_eq in E, H3, H2, H1. unfold says in S.
  apply (at_values _ _ _ qs) in S; [| exact E]. apply (at_values _ _ _ ss) in S; [| exact H3].
  apply imply_iff in S; [| exact H0]. rewrite H2, H1 in S. cbn [there_are] in S.
  rewrite 2!app_nil_r in S. apply truth_is in S. rewrite S in H. discriminate.
Qed.
Definition succeeds (st : statement) (qs : list (quaternion R)) (ss : list R) : bool :=
  let A := constants st List.nil in
  Nat.eqb (quaternions st) 0 && Nat.eqb (scalars st) 0 &&
  Nat.eqb (length qs) (found_quaternions st) && Nat.eqb (length ss) (found_scalars st) &&
  (if forallb (truth A List.nil List.nil) (given st) then truth A qs ss (conclusion st) else true).
Theorem example : forall st qs ss, succeeds st qs ss = true -> says st.
Proof.
  intros st qs ss E; unfold succeeds in E. repeat (apply andb_true_iff in E; destruct E as [E ?]).
  apply Nat.eqb_eq in E, H2, H1, H0. unfold says. rewrite E, H2. cbn [for_all].
  apply imply_iff. intro G. rewrite G in H.
  apply (with_values _ _ _ qs); [exact H1 |]. apply (with_values _ _ _ ss); [exact H0 |].
  apply truth_is, H.
Qed.

(* All cases. A list of values is a function, since most statements need none of the quaternions. *)
Variable elements : list R.
Hypothesis elements_are : forall x, In x elements.
Definition all_quaternions (_ : Datatypes.unit) : list (quaternion R) :=
  flat_map (fun a => flat_map (fun b => flat_map (fun c =>
    List.map (fun d => Quaternion a b c d) elements) elements) elements) elements.
Lemma all_quaternions_are : forall q, In q (all_quaternions tt).
Proof.
  intros [a b c d]. unfold all_quaternions.
  apply in_flat_map; exists a; split; [apply elements_are |].
  apply in_flat_map; exists b; split; [apply elements_are |].
  apply in_flat_map; exists c; split; [apply elements_are |]. apply in_map, elements_are.
Qed.
Fixpoint every_case {T} (values : Datatypes.unit -> list T) (n : nat) (P : list T -> bool) : bool :=
  match n with
  | O => P List.nil
  | S m => forallb (fun x => every_case values m (fun l => P (List.cons x l))) (values tt)
  end.
Fixpoint some_case {T} (values : Datatypes.unit -> list T) (n : nat) (P : list T -> bool) : bool :=
  match n with
  | O => P List.nil
  | S m => existsb (fun x => some_case values m (fun l => P (List.cons x l))) (values tt)
  end.
Lemma every_case_is : forall T (values : Datatypes.unit -> list T), (forall x, In x (values tt)) -> forall n P,
  every_case values n P = true -> forall l, length l = n -> P l = true.
Proof.
  intros T values F; induction n as [| n IH]; intros P E [| x l] L; try discriminate L; [exact E |].
  cbn [every_case] in E. rewrite forallb_forall in E.
  exact (IH (fun l => P (List.cons x l)) (E x (F x)) l (eq_add_S _ _ L)).
Qed.
Lemma some_case_is : forall T (values : Datatypes.unit -> list T) n P,
  some_case values n P = true -> exists l, length l = n /\ P l = true.
Proof.
  intros T values; induction n as [| n IH]; intros P E; [exists List.nil; split; [reflexivity | exact E] |].
  cbn [some_case] in E. apply existsb_exists in E; destruct E as [x [_ E]].
  destruct (IH _ E) as [l [L F]]. exists (List.cons x l); split; [cbn; congruence | exact F].
Qed.
Definition exhausted (st : statement) : bool :=
  let all_scalars := fun _ => elements in
  every_case all_quaternions (quaternions st) (fun qs => every_case all_scalars (scalars st) (fun ss =>
    let A := constants st ss in
    if forallb (truth A qs ss) (given st) then
      some_case all_quaternions (found_quaternions st) (fun more =>
        some_case all_scalars (found_scalars st) (fun others =>
          truth A (qs ++ more) (ss ++ others) (conclusion st)))
    else true)).
Theorem all_cases : forall st, exhausted st = true -> says st.
Proof.
  intros st E. apply same_for_all; intros qs Wq. apply same_for_all; intros ss Ws.
  apply imply_iff. intro G. unfold exhausted in E.
  apply (every_case_is _ _ all_quaternions_are _ _ E) in Wq.
  apply (every_case_is _ _ (elements_are : forall x, In x ((fun _ => elements) tt)) _ _ Wq) in Ws. cbv zeta in Ws. rewrite G in Ws.
  apply some_case_is in Ws; destruct Ws as [more [M F]].
  apply some_case_is in F; destruct F as [others [N F]].
  apply (with_values _ _ _ more M). apply (with_values _ _ _ others N). apply truth_is, F.
Qed.
End Decided.

(* The integers. *)
Global Instance integer_operations : Operations Z := {|
  zero := 0%Z; one := 1%Z; add := Z.add; mul := Z.mul; sub := Z.sub; opp := Z.opp |}.
Global Instance integer_inverse : Inverse Z := fun x => x.
Lemma integer_laws : ring_theory zero one add mul sub opp (@eq Z).
Proof. exact Zth. Qed.
Lemma integer_units : forall x y : Z, x * y = 1 -> x * inv x = 1.
Proof.
  cbn. intros x y E. unfold inv, integer_inverse. destruct (Z.mul_eq_1 _ _ E) as [-> | ->]; reflexivity.
Qed.

(* The residues modulo n; [GF p] if n is a prime p. *)
Section Residues.
Variable n : Z.
Record residues := Residue { representative : Z; is_reduced : Z.eqb (representative mod n) representative = true }.
Lemma reduced_mod : forall z, Z.eqb ((z mod n) mod n) (z mod n) = true.
Proof. intro z. apply Z.eqb_eq, Zmod_mod. Qed.
Definition reduce (z : Z) : residues := Residue (z mod n) (reduced_mod z).
Lemma residues_equal : forall x y, representative x = representative y -> x = y.
Proof.
  intros [x r] [y s] E; cbn in E; subst y. f_equal.
  apply Eqdep_dec.UIP_dec, bool_dec.
Qed.
Lemma reduce_representative : forall x, reduce (representative x) = x.
Proof. intros [x r]. apply residues_equal; cbn. apply Z.eqb_eq, r. Qed.
Lemma representative_mod : forall x, representative x = (representative x mod n)%Z.
Proof. intros [x r]. cbn. symmetry. apply Z.eqb_eq, r. Qed.
Global Instance residue_operations : Operations residues := {|
  zero := reduce 0; one := reduce 1;
  add x y := reduce (representative x + representative y);
  mul x y := reduce (representative x * representative y);
  sub x y := reduce (representative x - representative y);
  opp x := reduce (- representative x) |}.
Lemma reduce_add : forall a b, add (reduce a) (reduce b) = reduce (a + b).
Proof. intros; apply residues_equal; cbn. symmetry; apply Zplus_mod. Qed.
Lemma reduce_mul : forall a b, mul (reduce a) (reduce b) = reduce (a * b).
Proof. intros; apply residues_equal; cbn. symmetry; apply Zmult_mod. Qed.
Lemma reduce_sub : forall a b, sub (reduce a) (reduce b) = reduce (a - b).
Proof. intros; apply residues_equal; cbn. symmetry; apply Zminus_mod. Qed.
Lemma reduce_opp : forall a, opp (reduce a) = reduce (- a).
Proof.
  intros; apply residues_equal; cbn. rewrite <- (Z.sub_0_l (a mod n)), <- (Z.sub_0_l a).
  rewrite Zminus_mod, Zmod_mod, <- Zminus_mod. reflexivity.
Qed.
Lemma residue_laws : ring_theory zero one add mul sub opp (@eq residues).
Proof.
  constructor; intros; repeat match goal with x : residues |- _ =>
    rewrite <- (reduce_representative x); generalize (representative x); clear x; intro end;
  change (@zero residues residue_operations) with (reduce 0);
  change (@one residues residue_operations) with (reduce 1);
  rewrite ?reduce_opp, ?reduce_add, ?reduce_mul, ?reduce_sub, ?reduce_add, ?reduce_mul, ?reduce_add; f_equal; ring.
Qed.
Definition residue_eqb (x y : residues) : bool := Z.eqb (representative x) (representative y).
Lemma residue_eqb_is : forall x y, residue_eqb x y = true <-> x = y.
Proof.
  intros x y; unfold residue_eqb. rewrite Z.eqb_eq. split; [apply residues_equal | congruence].
Qed.
Definition all_residues : list residues :=
  List.map (fun k => reduce (Z.of_nat k)) (List.seq 0 (Z.to_nat n)).
Global Instance residue_inverse : Inverse residues := fun x =>
  match List.find (fun y => residue_eqb (mul x y) one) all_residues with Some y => y | None => zero end.
Hypothesis positive : Z.ltb 0 n = true.
Lemma all_residues_are : forall x, In x all_residues.
Proof.
  intro x. apply Z.ltb_lt in positive. rewrite <- (reduce_representative x). apply in_map_iff.
  assert (E := representative_mod x).
  assert (B := Z.mod_pos_bound (representative x) n positive). rewrite <- E in B.
  exists (Z.to_nat (representative x)). split; [rewrite Z2Nat.id by lia; reflexivity |].
  apply in_seq. split; [lia |]. cbn. apply Z2Nat.inj_lt; lia.
Qed.
Lemma residue_inverse_is : forall x y : residues, mul x y = one -> mul x (inv x) = one.
Proof.
  intros x y E. unfold inv, residue_inverse.
  destruct (List.find _ all_residues) as [z |] eqn:F.
  - apply find_some in F. apply residue_eqb_is, (proj2 F).
  - apply find_none with (x := y) in F; [| apply all_residues_are].
    apply residue_eqb_is in E. rewrite E in F. discriminate.
Qed.
(* A prime: all smaller numbers are prime to it. *)
Definition is_prime : bool :=
  Z.ltb 1 n && forallb (fun k => Z.eqb (Z.gcd (Z.of_nat k) n) 1) (List.seq 1 (Z.to_nat (n - 1))).
Hypothesis prime_n : is_prime = true.
Lemma residue_field_laws : field_theory zero one add mul sub opp (fun x y => x / y) inv (@eq residues).
Proof.
  assert (P := prime_n). unfold is_prime in P. apply andb_true_iff in P; destruct P as [L P]. apply Z.ltb_lt in L.
  constructor; [exact residue_laws | | reflexivity |].
  - intro E. apply (f_equal representative) in E. change (1 mod n = 0 mod n)%Z in E. rewrite 2!Z.mod_small in E by lia. discriminate.
  - intros x N. rewrite (Rmul_comm residue_laws).
    assert (B := Z.mod_pos_bound (representative x) n ltac:(lia)).
    assert (E := representative_mod x).
    rewrite <- E in B.
    assert (M : representative x <> 0%Z).
    { intro M. apply N. rewrite <- (reduce_representative x), M. reflexivity. }
    rewrite forallb_forall in P. specialize (P (Z.to_nat (representative x))).
    rewrite Z2Nat.id in P by lia.
    assert (G : Z.eqb (Z.gcd (representative x) n) 1 = true).
    { apply P, in_seq. split; [apply (Z2Nat.inj_le 1); lia |]. rewrite Z2Nat.inj_sub by lia. 
      change (Z.to_nat 1) with 1%nat. assert (Z.to_nat (representative x) < Z.to_nat n)%nat by (apply Z2Nat.inj_lt; lia). lia. }
    apply Z.eqb_eq in G. destruct (rel_prime_bezout _ _ (proj1 (Zgcd_1_rel_prime _ _) G)) as [u v W].
    apply (residue_inverse_is x (reduce u)). rewrite <- (reduce_representative x), reduce_mul.
    apply residues_equal. cbn. replace (representative x * u)%Z with (1 + (- v) * n)%Z by lia.
    apply Z_mod_plus_full.
Qed.
Lemma residue_equal_or_not : forall x y : residues, x = y \/ x <> y.
Proof.
  intros x y. destruct (residue_eqb x y) eqn:E; [left; apply residue_eqb_is, E | right].
  intros ->. rewrite (proj2 (residue_eqb_is y y) eq_refl) in E. discriminate.
Qed.
Lemma num_reduce : forall z : Z, num z = reduce z.
Proof.
  intro z. assert (M := gen_phiZ_morph (Eqsth residues) (Eq_ext add mul opp) residue_laws).
  rewrite <- (reduce_representative (num z)). 
  assert (H : forall p, num (Z.pos p) = reduce (Z.pos p)).
  { intro p. induction p using Pos.peano_ind; [reflexivity |].
    rewrite Pos2Z.inj_succ, <- Z.add_1_r. etransitivity; [exact (morph_add M (Z.pos p) 1) |].
    change (add (num (Z.pos p)) (num 1) = reduce (Z.pos p + 1)). rewrite IHp.
    change (num 1) with (reduce 1). apply reduce_add. }
  rewrite reduce_representative. destruct z as [| p | p]; [reflexivity | apply H |].
  change (opp (num (Z.pos p)) = reduce (- Z.pos p)). rewrite H. apply reduce_opp.
Qed.
Lemma modulus_vanishes : num n = (zero : residues).
Proof. rewrite num_reduce. apply residues_equal. change (n mod n = 0 mod n)%Z. rewrite Z_mod_same_full, Zmod_0_l. reflexivity. Qed.
End Residues.
Notation GF := residues.


(* ---------------------------------------------------------------------------------------------- *)
(* Every commutative ring.                                                                        *)
(* ---------------------------------------------------------------------------------------------- *)

Section Commutative_rings.
Context {R : Type} {operations : Operations R}.
Hypothesis laws : ring_theory zero one add mul sub opp (@eq R).
Add Ring commutative_ring : laws.
Local Open Scope scalar_scope.
Local Notation nil := (combination_nil).
Local Notation cons c equation rest := (combination_cons laws c _ _ _ equation rest).
Ltac calculate := first [polynomials laws | unfolded; ring].
Ltac equations :=
  intros; repeat match goal with |- _ /\ _ => split end; try apply coordinates; calculate.
Ltac combine proof := refine (by_combination laws _ _ _ proof _); calculate.
Implicit Types (p q r : quaternion R) (A : algebra R) (s x y : R).

(* The algebra with any structure constants. *)
Theorem products_of_the_basis : forall A,
  i [*A] i = embed (const_a A) [+] (const_t A [.] i) /\ j [*A] j = embed (const_b A) /\
  i [*A] j = k /\ j [*A] i = (const_t A [.] j) [-] k.
Proof. equations. Qed.
Theorem associative : forall A p q r, (p [*A] q) [*A] r = p [*A] (q [*A] r).
Proof. equations. Qed.
Theorem distributive : forall A p q r,
  p [*A] (q [+] r) = (p [*A] q) [+] (p [*A] r) /\ (p [+] q) [*A] r = (p [*A] r) [+] (q [*A] r).
Proof. equations. Qed.
Theorem bilinear : forall A s p q,
  (s [.] p) [*A] q = s [.] (p [*A] q) /\ p [*A] (s [.] q) = s [.] (p [*A] q).
Proof. equations. Qed.
Theorem identity : forall A q, e [*A] q = q /\ q [*A] e = q.
Proof. equations. Qed.
Theorem conj_involution : forall A q, conj A (conj A q) = q.
Proof. equations. Qed.
Theorem conj_sum : forall A p q, conj A (p [+] q) = conj A p [+] conj A q.
Proof. equations. Qed.
Theorem conj_product : forall A p q, conj A (p [*A] q) = conj A q [*A] conj A p.
Proof. equations. Qed.
Theorem norm_by_conj : forall A q,
  q [*A] conj A q = embed (norm A q) /\ conj A q [*A] q = embed (norm A q).
Proof. equations. Qed.
Theorem norm_product : forall A p q, norm A (p [*A] q) = norm A p * norm A q.
Proof. equations. Qed.
Theorem trace_by_conj : forall A q, q [+] conj A q = embed (trace A q).
Proof. equations. Qed.
Theorem trace_symmetric : forall A p q, trace A (p [*A] q) = trace A (q [*A] p).
Proof. equations. Qed.
Theorem cayley_hamilton : forall A q,
  ((q [*A] q) [-] (trace A q [.] q)) [+] embed (norm A q) = embed 0.
Proof. equations. Qed.

(* The quaternions of Hamilton, H = H(R). *)
Theorem table_1_1 :
  (e [*H] e = e /\ e [*H] i = i /\ e [*H] j = j /\ e [*H] k = k) /\
  (i [*H] e = i /\ i [*H] i = [-] e /\ i [*H] j = k /\ i [*H] k = [-] j) /\
  (j [*H] e = j /\ j [*H] i = [-] k /\ j [*H] j = [-] e /\ j [*H] k = i) /\
  (k [*H] e = k /\ k [*H] i = j /\ k [*H] j = [-] i /\ k [*H] k = [-] e).
Proof. equations. Qed.
Theorem norm_of_coordinates : forall q,
  norm H q = re q * re q + im q * im q + jm q * jm q + km q * km q.
Proof. equations. Qed.
Theorem euler_four_squares : forall a b c d w x y z : R,
  (a*a + b*b + c*c + d*d) * (w*w + x*x + y*y + z*z) =
  (a*w - b*x - c*y - d*z) * (a*w - b*x - c*y - d*z) +
  (a*x + b*w + c*z - d*y) * (a*x + b*w + c*z - d*y) +
  (a*y - b*z + c*w + d*x) * (a*y - b*z + c*w + d*x) +
  (a*z + b*y - c*x + d*w) * (a*z + b*y - c*x + d*w).
Proof. equations. Qed.
Theorem commutator : forall p q,
  comm H p q = num 2 [.] Quaternion 0 (jm p * km q - km p * jm q) (km p * im q - im p * km q)
                                      (im p * jm q - jm p * im q).
Proof. equations. Qed.
Lemma qsub_zero : forall p q, p [-] q = embed 0 -> p = q.
Proof.
  intros p q E; apply coordinates.
  - combine (cons 1 (f_equal re E) nil).
  - combine (cons 1 (f_equal im E) nil).
  - combine (cons 1 (f_equal jm E) nil).
  - combine (cons 1 (f_equal km E) nil).
Qed.
Theorem commutative_iff_two_is_zero : (forall p q, p [*H] q = q [*H] p) <-> num 2 = 0.
Proof.
  split; [intro C | intros two p q].
  - combine (cons 1 (f_equal km (C i j)) nil).
  - apply qsub_zero. change (comm H p q = embed 0). rewrite commutator, two. equations.
Qed.
Theorem square_in_char_2 : num 2 = 0 -> forall q, q [*H] q = embed (norm H q).
Proof.
  intros two q; apply coordinates.
  - combine (cons (- (im q * im q + jm q * jm q + km q * km q)) two nil).
  - combine (cons (re q * im q) two nil).
  - combine (cons (re q * jm q) two nil).
  - combine (cons (re q * km q) two nil).
Qed.
Theorem norm_in_char_2 : num 2 = 0 -> forall q,
  norm H q = (re q + im q + jm q + km q) * (re q + im q + jm q + km q).
Proof.
  intros two q.
  combine (cons (- (re q * (im q + jm q + km q) + im q * (jm q + km q) + jm q * km q))
             two nil).
Qed.
Theorem centre : (forall x, num 2 * x = 0 -> x = 0) ->
  forall q, (forall p, p [*H] q = q [*H] p) <-> exists s, q = embed s.
Proof.
  intros regular q; split; [intro C; exists (re q) | intros [s ->] p; equations].
  apply coordinates; [reflexivity | apply regular .. ].
  - combine (cons (- (1)) (f_equal km (C j)) nil).
  - combine (cons 1 (f_equal km (C i)) nil).
  - combine (cons (- (1)) (f_equal jm (C i)) nil).
Qed.
Theorem centre_in_char_2 : num 2 = 0 -> forall q p, p [*H] q = q [*H] p.
Proof. intros two q p. apply commutative_iff_two_is_zero, two. Qed.

(* Inverses. *)
Theorem inverse_from_norm : forall A q u, norm A q * u = 1 ->
  q [*A] (u [.] conj A q) = e /\ (u [.] conj A q) [*A] q = e.
Proof.
  intros A q u E; split; apply coordinates;
    first [calculate | combine (cons 1 E nil)].
Qed.
Theorem norm_of_invertible : forall A p q, p [*A] q = e -> norm A p * norm A q = 1.
Proof. intros A p q E. rewrite <- norm_product, E. calculate. Qed.
Theorem one_sided_inverse : forall A p q, p [*A] q = e -> q [*A] p = e.
Proof.
  intros A p q E. destruct (inverse_from_norm A p (norm A q) (norm_of_invertible A p q E)) as [_ L].
  set (u := norm A q [.] conj A p) in *.
  transitivity ((u [*A] p) [*A] (q [*A] p)); [rewrite L; symmetry; apply identity |].
  rewrite associative, <- (associative A p q p), E.
  transitivity (u [*A] p); [f_equal; apply identity | exact L].
Qed.
Theorem invertible_iff_norm_is : forall A q,
  (exists p, q [*A] p = e /\ p [*A] q = e) <-> exists u, norm A q * u = 1.
Proof.
  intros A q; split.
  - intros [p [E _]]. exists (norm A p). apply norm_of_invertible, E.
  - intros [u E]. exists (u [.] conj A q). apply inverse_from_norm, E.
Qed.
Theorem norm_zero_divides_zero : forall A q, norm A q = 0 -> q [*A] conj A q = embed 0.
Proof. intros A q E. destruct (norm_by_conj A q) as [-> _]. rewrite E. reflexivity. Qed.

(* Quaternions as matrices [[z, w], [-conj w, conj z]], whose entries are elements a + b*i of H. *)
Definition complex a b := Quaternion a b 0 0.
Definition entry_z q := complex (re q) (im q).
Definition entry_w q := complex (jm q) (km q).
Ltac matrices := cbv [complex entry_z entry_w]; equations.
Theorem entries_commute : forall a b c d : R,
  complex a b [*H] complex c d = complex c d [*H] complex a b.
Proof. matrices. Qed.
Theorem matrix_of_product : forall p q,
  let (z, w) := (entry_z p, entry_w p) in let (u, v) := (entry_z q, entry_w q) in
  (z [*H] u) [-] (w [*H] conj H v) = entry_z (p [*H] q) /\
  (z [*H] v) [+] (w [*H] conj H u) = entry_w (p [*H] q).
Proof. matrices. Qed.
Theorem matrix_of_conj : forall q,
  entry_z (conj H q) = conj H (entry_z q) /\ entry_w (conj H q) = [-] entry_w q.
Proof. matrices. Qed.
Theorem determinant_is_norm : forall q,
  let (z, w) := (entry_z q, entry_w q) in
  (z [*H] conj H z) [+] (w [*H] conj H w) = embed (norm H q).
Proof. matrices. Qed.

(* Rotations: the matrix of v |-> q v conj(q) has the rows below. *)
Definition row n q : R * R * R :=
  let '(a, b, c, d) := (re q, im q, jm q, km q) in
  match n with
  | O => (a*a + b*b - c*c - d*d, num 2 * (b*c - a*d), num 2 * (b*d + a*c))
  | S O => (num 2 * (b*c + a*d), a*a - b*b + c*c - d*d, num 2 * (c*d - a*b))
  | _ => (num 2 * (b*d - a*c), num 2 * (c*d + a*b), a*a - b*b - c*c + d*d)
  end.
Definition dot (u v : R * R * R) := let '(a, b, c) := u in let '(x, y, z) := v in a*x + b*y + c*z.
Definition cross (u v : R * R * R) := let '(a, b, c) := u in let '(x, y, z) := v in
  (b*z - c*y, c*x - a*z, a*y - b*x).
Ltac rotations := cbv [row dot cross]; equations.
Theorem rotation_by_conjugation : forall q x y z,
  (q [*H] Quaternion 0 x y z) [*H] conj H q =
  Quaternion 0 (dot (row 0 q) (x, y, z)) (dot (row 1 q) (x, y, z)) (dot (row 2 q) (x, y, z)).
Proof. rotations. Qed.
Lemma rows_of_any_norm : forall q, let n := norm H q in
  (dot (row 0 q) (row 0 q) = n*n /\ dot (row 1 q) (row 1 q) = n*n /\
   dot (row 2 q) (row 2 q) = n*n) /\
  (dot (row 0 q) (row 1 q) = 0 /\ dot (row 0 q) (row 2 q) = 0 /\ dot (row 1 q) (row 2 q) = 0) /\
  dot (row 0 q) (cross (row 1 q) (row 2 q)) = n*n*n.
Proof. rotations. Qed.
Theorem rotation_is_orthogonal : forall q, norm H q = 1 ->
  (dot (row 0 q) (row 0 q) = 1 /\ dot (row 1 q) (row 1 q) = 1 /\ dot (row 2 q) (row 2 q) = 1) /\
  (dot (row 0 q) (row 1 q) = 0 /\ dot (row 0 q) (row 2 q) = 0 /\ dot (row 1 q) (row 2 q) = 0).
Proof.
  intros q U. destruct (rows_of_any_norm q) as [L [O _]]. rewrite U in L.
  replace (1 * 1) with (1 : R) in L by ring. split; assumption.
Qed.
Theorem rotation_has_determinant_1 : forall q, norm H q = 1 ->
  dot (row 0 q) (cross (row 1 q) (row 2 q)) = 1.
Proof.
  intros q U. destruct (rows_of_any_norm q) as [_ [_ ->]]. rewrite U. ring.
Qed.

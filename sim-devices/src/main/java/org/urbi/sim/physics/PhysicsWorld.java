package org.urbi.sim.physics;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import org.urbi.sim.SimulationException;
import org.urbi.sim.geometry.Pose;
import org.urbi.sim.geometry.Vec3;

/**
 * Bodies and joints that advance in fixed steps. A run depends only on the sequence of calls: two
 * runs with the same calls give the same bits.
 *
 * <p>One thread at a time uses it.
 */
public final class PhysicsWorld implements AutoCloseable {
  private final PhysicsSettings settings;
  private final PhysicsEngine engine;
  private final Dynamics dynamics;
  private final List<Body> bodies = new ArrayList<>();
  private final List<Joint> joints = new ArrayList<>();

  /** For each shape, by number: whose it is, and which of its parts. */
  private final List<Body> owners = new ArrayList<>();

  private final List<Integer> partNumbers = new ArrayList<>();
  private final List<Material> materials = new ArrayList<>();

  /** Pairs of bodies that a joint connects: they do not collide. */
  private final Set<Long> connected = new HashSet<>();

  private long[] pairs = new long[64];
  private int pairCount;
  private final double[] touching = new double[Dynamics.CONTACTS_PER_PAIR * Dynamics.CONTACT_SIZE];

  /** Of the last step: two shapes, and the numbers of {@link Dynamics#collide}. */
  private int[] contactGeoms = new int[64];

  private double[] contactNumbers = new double[32 * Dynamics.CONTACT_SIZE];
  private int contactCount;

  private long steps;
  private long version;
  private boolean closed;

  public PhysicsWorld(PhysicsEngine engine, PhysicsSettings settings) {
    this.engine = engine;
    this.settings = settings;
    this.dynamics = engine.createDynamics(settings);
  }

  public PhysicsSettings settings() {
    return settings;
  }

  public PhysicsEngine engine() {
    return engine;
  }

  /** All of them, as they were made. */
  public List<Body> bodies() {
    return Collections.unmodifiableList(bodies);
  }

  /** All of them, as they were made. */
  public List<Joint> joints() {
    return Collections.unmodifiableList(joints);
  }

  /** How many steps it has gone on. */
  public long steps() {
    return steps;
  }

  /** In seconds. */
  public double time() {
    return steps * settings.step();
  }

  Dynamics dynamics() {
    if (closed) {
      throw new SimulationException("this world has been closed");
    }
    return dynamics;
  }

  /** Grows whenever a body may have moved. */
  long version() {
    return version;
  }

  void changed() {
    version++;
  }

  /** Makes a body. */
  public Body add(BodyDescription description) {
    int number = Dynamics.WORLD;
    Vec3 centre = Vec3.ZERO;
    if (!description.fixed()) {
      MassProperties mass = MassProperties.of(description.mass(), description.parts());
      if (!mass.isUsable()) {
        throw new SimulationException(
            description.name() + ": too thin beside its length: it would turn without effort");
      }
      centre = mass.centre();
      number = dynamics().createBody(mass.mass(), mass.inertia());
    }
    Body body = new Body(this, description, bodies.size(), number, owners.size(), centre);
    for (int i = 0; i < description.parts().size(); i++) {
      BodyDescription.Part part = description.parts().get(i);
      Pose pose =
          description.fixed()
              ? description.pose().apply(part.pose())
              : new Pose(part.pose().position().minus(centre), part.pose().rotation());
      dynamics().createGeom(number, part.shape(), pose);
      owners.add(body);
      partNumbers.add(i);
      materials.add(part.material());
    }
    body.place(description.pose());
    bodies.add(body);
    return body;
  }

  /** Makes a joint between bodies as they stand now. */
  public Joint add(JointDescription d) {
    int first = d.first() == null ? Dynamics.WORLD : d.first().number();
    int second = d.second().number();
    int number = dynamics().createJoint(d.kind(), first, second, d.anchor(), d.axis());
    Joint joint = new Joint(this, d, number);
    if (joint.canBeDriven()) {
      dynamics().setLimits(number, d.low(), d.high());
    }
    if (d.first() != null) {
      connected.add(pair(d.first().index(), d.second().index()));
    }
    joints.add(joint);
    return joint;
  }

  private static long pair(int a, int b) {
    return (long) Math.min(a, b) << 32 | Math.max(a, b) & 0xffffffffL;
  }

  /**
   * Goes on by one step.
   *
   * @throws SimulationException if a body then moves so fast that the world has gone wrong: libode
   *     would end the process when numbers overflow. All bodies are where they were, and at rest
   */
  public void step() {
    for (Body body : bodies) {
      body.remember();
    }
    findContacts();
    try {
      dynamics.step(steps);
      version++;
      for (Body body : bodies) {
        body.requireSane();
      }
    } catch (SimulationException e) {
      for (Body body : bodies) {
        body.restore();
      }
      throw e;
    }
    steps++;
    for (Joint joint : joints) {
      joint.followAngle();
    }
  }

  /** Keeps how all bodies are now, for {@link #restart}. */
  public void keepStart() {
    bodies.forEach(Body::keepStart);
  }

  /** Has all bodies be again as they were when that was kept. Time goes on. */
  public void restart() {
    bodies.forEach(Body::restart);
    joints.forEach(Joint::restart);
    contactCount = 0;
  }

  private void notePair(int first, int second) {
    Body a = owners.get(first);
    Body b = owners.get(second);
    if (a == b || connected.contains(pair(a.index(), b.index()))) {
      return;
    }
    if (pairCount == pairs.length) {
      pairs = Arrays.copyOf(pairs, 2 * pairCount);
    }
    pairs[pairCount++] = pair(first, second);
  }

  private void findContacts() {
    contactCount = 0;
    pairCount = 0;
    dynamics().findNearPairs(this::notePair);
    // Engines find pairs in orders of their own, but contacts are always taken in this one.
    Arrays.sort(pairs, 0, pairCount);
    for (int i = 0; i < pairCount; i++) {
      int first = (int) (pairs[i] >> 32);
      int second = (int) pairs[i];
      int count = dynamics.collide(first, second, touching);
      if (count > 0) {
        Material material = materials.get(first).touching(materials.get(second));
        dynamics.keepContacts(
            owners.get(first).number(), owners.get(second).number(), count, material);
        for (int j = 0; j < count; j++) {
          noteContact(first, second, j * Dynamics.CONTACT_SIZE);
        }
      }
    }
  }

  private void noteContact(int first, int second, int at) {
    if (2 * contactCount == contactGeoms.length) {
      contactGeoms = Arrays.copyOf(contactGeoms, 4 * contactCount);
      contactNumbers = Arrays.copyOf(contactNumbers, 2 * contactNumbers.length);
    }
    contactGeoms[2 * contactCount] = first;
    contactGeoms[2 * contactCount + 1] = second;
    System.arraycopy(
        touching, at, contactNumbers, contactCount * Dynamics.CONTACT_SIZE, Dynamics.CONTACT_SIZE);
    contactCount++;
  }

  /** Where bodies touched in the last step. */
  public List<Contact> contacts() {
    List<Contact> contacts = new ArrayList<>(contactCount);
    for (int i = 0; i < contactCount; i++) {
      int first = contactGeoms[2 * i];
      int second = contactGeoms[2 * i + 1];
      int at = i * Dynamics.CONTACT_SIZE;
      contacts.add(
          new Contact(
              owners.get(first),
              partNumbers.get(first),
              owners.get(second),
              partNumbers.get(second),
              vector(contactNumbers, at),
              vector(contactNumbers, at + 3),
              contactNumbers[at + 6]));
    }
    return contacts;
  }

  /**
   * How deep a part of a body was in others in the last step, in metres: 0 if it touched none.
   *
   * @param part -1 for any
   */
  public double touch(Body body, int part) {
    double deepest = 0;
    for (int i = 0; i < contactCount; i++) {
      if (isPart(contactGeoms[2 * i], body, part) || isPart(contactGeoms[2 * i + 1], body, part)) {
        double depth = contactNumbers[i * Dynamics.CONTACT_SIZE + 6];
        deepest = Math.max(deepest, Math.max(depth, Double.MIN_NORMAL));
      }
    }
    return deepest;
  }

  private boolean isPart(int geom, Body body, int part) {
    return owners.get(geom) == body && (part < 0 || partNumbers.get(geom) == part);
  }

  private static Vec3 vector(double[] numbers, int at) {
    return new Vec3(numbers[at], numbers[at + 1], numbers[at + 2]);
  }

  /**
   * What a ray meets first, as the bodies stand now.
   *
   * @param length in metres
   * @param seen which bodies count
   */
  public Optional<RayHit> castRay(Vec3 from, Vec3 direction, double length, Predicate<Body> seen) {
    EngineLimits.within(from, 4 * EngineLimits.FARTHEST, "a ray");
    EngineLimits.within(length, 4 * EngineLimits.FARTHEST, "the length of a ray");
    Vec3 unit = direction.normalized();
    List<Integer> candidates = new ArrayList<>();
    dynamics()
        .findOnRay(
            from,
            unit,
            length,
            (ray, geom) -> {
              if (seen.test(owners.get(geom))) {
                candidates.add(geom);
              }
            });
    Collections.sort(candidates);
    RayHit nearest = null;
    double[] found = new double[Dynamics.CONTACT_SIZE];
    for (int geom : candidates) {
      if (dynamics.meet(geom, found) && (nearest == null || found[6] < nearest.distance())) {
        nearest =
            new RayHit(
                owners.get(geom),
                partNumbers.get(geom),
                found[6],
                vector(found, 0),
                vector(found, 3));
      }
    }
    return Optional.ofNullable(nearest);
  }

  /** Frees what the engine holds; nothing can be done with it afterwards. */
  @Override
  public void close() {
    if (!closed) {
      closed = true;
      dynamics.close();
    }
  }
}

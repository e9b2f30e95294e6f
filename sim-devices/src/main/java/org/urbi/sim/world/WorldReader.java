package org.urbi.sim.world;

import static java.util.Objects.requireNonNullElse;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.urbi.sim.SimulationException;
import org.urbi.sim.geometry.Vec3;
import org.urbi.sim.physics.Body;
import org.urbi.sim.physics.BodyDescription;
import org.urbi.sim.physics.Joint;
import org.urbi.sim.physics.JointDescription;
import org.urbi.sim.physics.JointDescription.Kind;
import org.urbi.sim.physics.Material;
import org.urbi.sim.physics.PhysicsSettings;
import org.urbi.sim.physics.PhysicsSettings.Solver;
import org.urbi.sim.physics.PhysicsWorld;
import org.urbi.sim.render.Appearance;
import org.urbi.sim.render.Colour;
import org.urbi.sim.render.Light;
import org.urbi.sim.world.WorldFileException.Place;

/**
 * Reads a world file. The format is described in docs/simulation.md. What a block refers to has to
 * stand before it.
 */
public final class WorldReader {
  /**
   * With more bodies that move, a world has the quick solver unless it says otherwise: the time of
   * the exact one grows with the cube of what touches.
   */
  private static final int MAX_EXACT = 40;

  private final Map<String, WorldMaterial> substances = new HashMap<>();
  private final Map<String, Map<String, Integer>> partNames = new HashMap<>();
  private final SimulatedWorld world;

  private WorldReader(SimulatedWorld world) {
    this.world = world;
  }

  /**
   * Reads a file.
   *
   * @param engine as {@link PhysicsEngines#named} knows it, or null for what the file says
   * @throws SimulationException if it cannot be read, or has a mistake
   */
  public static SimulatedWorld read(Path file, @Nullable String engine) {
    if (Files.exists(file) && !Files.isRegularFile(file)) {
      // Whoever reads a pipe or a device may wait for ever: that would be the kernel.
      throw new SimulationException(file + ": not a regular file");
    }
    try {
      return read(file.getFileName().toString(), Files.readString(file), engine);
    } catch (NoSuchFileException e) {
      throw new SimulationException(file + ": no such file", e);
    } catch (CharacterCodingException e) {
      throw new SimulationException(file + ": not a text in UTF-8", e);
    } catch (IOException e) {
      throw new SimulationException(file + ": cannot be read: " + e.getMessage(), e);
    }
  }

  /** Reads a text; the name is for messages. */
  public static SimulatedWorld read(String name, String text, @Nullable String engine) {
    return build(BlockReader.read(name, text), new Place(name, 1, 1), engine);
  }

  private static SimulatedWorld build(List<Block> blocks, Place start, @Nullable String engine) {
    Block head = null;
    for (Block block : blocks) {
      if (block.kind().equals("world")) {
        if (head != null) {
          throw block.wrong("is given twice");
        }
        head = block;
      }
    }
    long moving =
        blocks.stream().filter(block -> block.kind().equals("body") && block.has("mass")).count();
    Solver usual = moving > MAX_EXACT ? Solver.QUICK : Solver.EXACT;
    var world = emptyWorld(head == null ? new Block("world", null, start) : head, engine, usual);
    var reader = new WorldReader(world);
    try {
      for (Block block : blocks) {
        if (block != head) {
          checked(block, () -> reader.add(block));
        }
      }
      world.begin();
      return world;
    } catch (RuntimeException e) {
      world.close();
      throw e;
    }
  }

  /** What the physics refuses is the mistake of a block. */
  private static void checked(Block block, Runnable reading) {
    try {
      reading.run();
    } catch (WorldFileException e) {
      throw e;
    } catch (SimulationException e) {
      throw new WorldFileException(block.place(), e.getMessage());
    }
  }

  private void add(Block block) {
    switch (block.kind()) {
      case "material" -> addMaterial(block);
      case "body" -> addBody(block);
      case "hinge" -> addJoint(block, Kind.HINGE);
      case "slider" -> addJoint(block, Kind.SLIDER);
      case "ball" -> addJoint(block, Kind.BALL);
      case "fixed" -> addJoint(block, Kind.FIXED);
      case "sun", "lamp" -> addLight(block);
      case "robot" -> addRobot(block);
      default -> {
        if (!new MountReader(world, partNames).add(block)) {
          throw new WorldFileException(
              block.place(),
              "unknown kind of block '"
                  + block.kind()
                  + "'; there are world, material, body, hinge, slider, ball, fixed, sun, lamp,"
                  + " robot, "
                  + MountReader.KINDS);
        }
      }
    }
  }

  // ------------------------------------------------------------------ the world as a whole

  private static SimulatedWorld emptyWorld(Block block, @Nullable String engine, Solver usual) {
    block.requireNoName();
    block.requireNoBlocks();
    SimulatedWorld[] made = new SimulatedWorld[1];
    checked(block, () -> made[0] = settled(block, engine, usual));
    return made[0];
  }

  private static SimulatedWorld settled(Block block, @Nullable String engine, Solver usual) {
    PhysicsSettings defaults = PhysicsSettings.DEFAULT;
    double[] gravity = block.numbers("gravity", 3, Unit.NONE);
    double step = block.number("step", Unit.TIME, defaults.step());
    String word = block.has("solver") ? block.requiredWord("solver") : PhysicsEngines.ANY;
    Solver solver =
        switch (word) {
          case "exact" -> Solver.EXACT;
          case "quick" -> Solver.QUICK;
          case PhysicsEngines.ANY -> usual;
          default ->
              throw block.wrong("solver", "auto, exact or quick expected, not '" + word + "'");
        };
    int iterations = block.integer("iterations", defaults.iterations());
    String named = block.word("engine");
    double ambient = fraction(block, "ambient", 0.4);
    Colour background = colour(block, "background", new Colour(0.55, 0.7, 0.9));
    block.finish();
    PhysicsSettings settings =
        new PhysicsSettings(
            gravity == null ? defaults.gravity() : vector(gravity), step, solver, iterations);
    String chosen = engine != null ? engine : named != null ? named : PhysicsEngines.ANY;
    SimulatedWorld world =
        new SimulatedWorld(new PhysicsWorld(PhysicsEngines.named(chosen), settings));
    world.setLook(ambient, background);
    return world;
  }

  // ------------------------------------------------------------------ materials and bodies

  private void addMaterial(Block block) {
    block.requireNoBlocks();
    String name = block.name();
    if (substances.containsKey(name)) {
      throw block.wrong("there is another material of that name");
    }
    Material d = Material.DEFAULT;
    Material material =
        new Material(
            block.number("friction", Unit.NONE, d.friction()),
            block.number("bounce", Unit.NONE, d.bounce()),
            block.number("rolling", Unit.LENGTH, d.rolling()));
    substances.put(name, new WorldMaterial(material, appearance(block, Appearance.PLAIN)));
    block.finish();
  }

  private WorldMaterial substance(Block block, WorldMaterial otherwise) {
    WorldMaterial substance = otherwise;
    if (block.has("material")) {
      String name = block.requiredWord("material");
      substance = substances.get(name);
      if (substance == null) {
        throw block.wrong("material", "no material '" + name + "' before this line");
      }
    }
    return new WorldMaterial(substance.material(), appearance(block, substance.appearance()));
  }

  private static Appearance appearance(Block block, Appearance otherwise) {
    Colour colour = colour(block, "colour", otherwise.colour());
    Colour checker = colour(block, "checker");
    double tile = block.number("tile", Unit.LENGTH, otherwise.tile());
    if (!(tile > 0)) {
      throw block.wrong("tile", "more than 0 expected, not " + tile);
    }
    return new Appearance(
        colour,
        checker == null ? otherwise.second() : checker,
        tile,
        fraction(block, "shine", otherwise.shine()),
        otherwise.glow());
  }

  private void addBody(Block block) {
    String name = newName(block);
    Body from = GeometryReader.body(block, "from", world);
    double mass = block.number("mass", Unit.MASS, 0);
    WorldMaterial substance = substance(block, WorldMaterial.DEFAULT);
    List<BodyDescription.Part> parts = new ArrayList<>();
    List<Appearance> looks = new ArrayList<>();
    Map<String, Integer> names = new HashMap<>();
    for (Block shape : block.blocks()) {
      WorldMaterial own = substance(shape, substance);
      parts.add(
          new BodyDescription.Part(
              GeometryReader.shape(shape), GeometryReader.pose(shape), own.material()));
      looks.add(own.appearance());
      String partName = shape.optionalName();
      if (partName != null && names.put(partName, parts.size() - 1) != null) {
        throw shape.wrong("there is another part of that name");
      }
      shape.finish();
    }
    BodyDescription description =
        new BodyDescription(
            name,
            from == null
                ? GeometryReader.pose(block)
                : from.pose().apply(GeometryReader.pose(block)),
            mass,
            parts);
    double[] velocity = block.numbers("velocity", 3, Unit.NONE);
    double[] spin = block.numbers("spin", 3, Unit.NONE);
    block.finish();
    Body body = world.physics().add(description);
    if (velocity != null || spin != null) {
      body.move(
          velocity == null ? Vec3.ZERO : vector(velocity), spin == null ? Vec3.ZERO : vector(spin));
    }
    world.addBody(body, looks);
    partNames.put(name, names);
  }

  private String newName(Block block) {
    String name = block.name();
    if (world.has(name)) {
      throw block.wrong("there is something else of that name");
    }
    return name;
  }

  // ------------------------------------------------------------------ joints

  private void addJoint(Block block, Kind kind) {
    block.requireNoBlocks();
    String name = newName(block);
    List<String> of = block.words("of", 2);
    if (of == null) {
      throw block.wrong("of is missing: the two bodies that it joins");
    }
    Body first =
        of.getFirst().equals("world")
            ? null
            : GeometryReader.known(block, "of", of.getFirst(), world);
    Body second = GeometryReader.known(block, "of", of.get(1), world);
    Vec3 anchor = Vec3.ZERO;
    Vec3 axis = Vec3.Z;
    if (kind != Kind.FIXED) {
      double[] at = block.numbers("anchor", 3, Unit.LENGTH);
      anchor = at == null ? Vec3.ZERO : vector(at);
    }
    double low = Double.NEGATIVE_INFINITY;
    double high = Double.POSITIVE_INFINITY;
    Unit unit = kind == Kind.HINGE ? Unit.ANGLE : Unit.LENGTH;
    boolean driven = kind == Kind.HINGE || kind == Kind.SLIDER;
    if (driven) {
      axis = vector(block.requiredNumbers("axis", 3, Unit.NONE));
      if (!(axis.length() > 0)) {
        throw block.wrong("axis", "has no direction");
      }
      double[] limits = block.numbers("limits", 2, unit);
      if (limits != null) {
        low = limits[0];
        high = limits[1];
        if (low > 0 || high < 0) {
          throw block.wrong("limits", "0, where it stands, is not between them");
        }
      }
    }
    Vec3 worldAnchor = second.pose().apply(anchor);
    Vec3 worldAxis = second.pose().rotation().apply(axis);
    Joint joint =
        world
            .physics()
            .add(
                new JointDescription(name, kind, first, second, worldAnchor, worldAxis, low, high));
    world.addJoint(joint);
    if (driven && block.has("drive")) {
      addDrive(block, joint, unit);
    }
    block.finish();
  }

  private void addDrive(Block block, Joint joint, Unit unit) {
    Drive.Control control =
        switch (block.requiredWord("drive")) {
          case "position" -> Drive.Control.POSITION;
          case "speed" -> Drive.Control.SPEED;
          default -> throw block.wrong("drive", "position or speed expected");
        };
    double[] gains = block.numbers("gains", 3, Unit.NONE);
    world.addDrive(
        new Drive(
            joint,
            control,
            block.requiredNumber("force", Unit.NONE),
            block.number("speed", unit, 10),
            gains == null ? new double[] {20, 0, 0} : gains));
  }

  // ------------------------------------------------------------------ lights and robots

  private void addLight(Block block) {
    block.requireNoBlocks();
    Colour colour = colour(block, "colour", Colour.WHITE);
    Colour strength = colour.times(fraction(block, "strength", 0.7));
    world.addLight(
        block.kind().equals("sun")
            ? new Light.Sun(vector(block.requiredNumbers("direction", 3, Unit.NONE)), strength)
            : new Light.Lamp(vector(block.requiredNumbers("at", 3, Unit.LENGTH)), strength));
    block.finish();
  }

  private void addRobot(Block block) {
    block.requireNoBlocks();
    if (world.robot().isPresent()) {
      throw block.wrong("there is another robot");
    }
    List<String> wheels = block.words("wheels", 2);
    Supplier<WorldFileException> wrongWheels =
        () -> block.wrong("wheels", "the names of two hinges with 'drive speed' expected");
    Drive[] sides = new Drive[2];
    for (int i = 0; wheels != null && i < 2; i++) {
      String name = wheels.get(i);
      sides[i] =
          world.drives().stream()
              .filter(d -> d.name().equals(name) && d.control() == Drive.Control.SPEED)
              .findFirst()
              .orElseThrow(wrongWheels);
    }
    String kind = block.word("kind");
    String model = block.word("model");
    world.setRobot(
        new RobotDescription(
            block.name(),
            kind == null ? "wheeled" : kind,
            model == null ? "simulated" : model,
            sides[0],
            sides[1],
            wheels == null ? 0 : block.requiredNumber("radius", Unit.LENGTH),
            wheels == null ? 0 : block.requiredNumber("track", Unit.LENGTH)));
    block.finish();
  }

  // ------------------------------------------------------------------ kinds of values

  static Vec3 vector(double[] numbers) {
    return new Vec3(numbers[0], numbers[1], numbers[2]);
  }

  private static Colour colour(Block block, String property, Colour otherwise) {
    return requireNonNullElse(colour(block, property), otherwise);
  }

  private static @Nullable Colour colour(Block block, String property) {
    double[] numbers = block.numbers(property, 3, Unit.NONE);
    if (numbers == null) {
      return null;
    }
    for (double number : numbers) {
      if (!(number >= 0 && number <= 1)) {
        throw block.wrong(property, "numbers between 0 and 1 expected, not " + number);
      }
    }
    return new Colour(numbers[0], numbers[1], numbers[2]);
  }

  private static double fraction(Block block, String property, double otherwise) {
    double number = block.number(property, Unit.NONE, otherwise);
    if (!(number >= 0 && number <= 1)) {
      throw block.wrong(property, "number between 0 and 1 expected, not " + number);
    }
    return number;
  }
}

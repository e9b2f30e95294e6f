package org.urbi.sim.device;

import static org.urbi.sim.SimulationException.ready;

import org.jspecify.annotations.Nullable;
import org.urbi.sim.SimulationException;
import org.urbi.sim.page.PageServer;
import org.urbi.sim.page.Snapshot;
import org.urbi.sim.page.WorldDescription;
import org.urbi.web.Annexes;
import urbi.UEvent;
import urbi.UImage;
import urbi.UObject;
import urbi.UStart;
import urbi.UValue;
import urbi.UVar;

/**
 * A page for browsers that shows a world while it goes on, {@code new(WORLD, PORT)}: the scene from
 * above, what a camera sees and a detector finds in it, and the drives with their targets. It is
 * for this machine alone unless {@code host} is another address. {@code port} and {@code host} can
 * be changed; {@code url} is what to give to a browser, {@code viewers} how many are looking. Who
 * looks from this machine can intervene; each intervention is a call of {@code obey}, so that a
 * recording has it.
 */
@UStart
public final class SimPage extends UObject implements AutoCloseable {
  private static final String THIS_MACHINE = "127.0.0.1";

  private final UVar port = new UVar();
  private final UVar host = new UVar();
  private final UVar url = new UVar();
  private final UVar viewers = new UVar();

  /** Somebody drives the robot: forward in m/s, to the left in rad/s. */
  private final UEvent driven = new UEvent();

  private @Nullable SimWorld simulation;
  private @Nullable SimCamera camera;
  private @Nullable String imageVariable;
  private @Nullable BallDetector detector;
  private @Nullable UImage image;
  private long imageNumber;
  private @Nullable PageServer server;
  private String usedHost = THIS_MACHINE;

  public SimPage(String name) {
    super(name);
    UBindFunction("init");
  }

  /**
   * Begins to serve.
   *
   * @param wanted the port; 0 for any that is free
   * @throws SimulationException if there is no such world, or if the port cannot be used
   */
  public void init(String worldName, int wanted) {
    SimWorld found = SimWorld.named(this, worldName);
    simulation = found;
    serve(THIS_MACHINE, wanted);
    found.add(this);
    UBindVars(port, "port", host, "host", url, "url", viewers, "viewers");
    tellWhere();
    viewers.setValue(0);
    UNotifyChange(port, "moved");
    UNotifyChange(host, "moved");
    UNotifyAccess(viewers, "count");
    UBindEvent(driven, "driven");
    UBindFunctions("showCamera", "showDetector", "obey");
  }

  /** On a port of its own, and on that of the studio, if the server has one. */
  private void serve(String onHost, int onPort) {
    PageServer serving = new PageServer(onHost, onPort, setting(), this::order);
    server = serving;
    Annexes.of(getUContext())
        .put(get__name(), serving.annex(WorldDescription.title(ready(simulation).world())));
  }

  private void tellWhere() {
    PageServer present = ready(server);
    host.setValue(usedHost);
    port.setValue(present.port());
    url.setValue(present.url());
  }

  /** Serves the page on another port or host; if that fails the page stays where it was. */
  public void moved() {
    String newHost = host.stringValue();
    int newPort = port.intValue();
    PageServer old = ready(server);
    if (newPort == old.port() && newHost.equals(usedHost)) {
      return;
    }
    int oldPort = old.port();
    old.close();
    try {
      serve(newHost, newPort);
      usedHost = newHost;
    } catch (SimulationException e) {
      serve(usedHost, oldPort);
      throw e;
    } finally {
      tellWhere();
    }
  }

  private String setting() {
    return WorldDescription.of(ready(simulation).world(), camera == null ? null : camera.mount());
  }

  /** Somebody who looks wants something; on the thread of the page. */
  private void order(String viewer, String order) {
    getUContext().call(get__name(), "obey", new UValue(viewer), new UValue(order));
  }

  /**
   * Does what somebody wants who looks; who that is is told why it cannot be done.
   *
   * @param viewer who wants it, as the page knows them
   * @param order as {@link WorldOrder#read} takes it
   */
  public void obey(String viewer, String order) {
    try {
      WorldOrder.read(order).carryOut(ready(simulation), driven);
    } catch (SimulationException e) {
      ready(server).tell(viewer, String.valueOf(e.getMessage()));
    }
  }

  /**
   * Shows what a camera sees, from now on.
   *
   * @param name that of the UObject
   * @throws SimulationException if it is no camera of this world
   */
  public void showCamera(String name) {
    if (!(getUContext().getUObject(name) instanceof SimCamera found)
        || found.simulation() != simulation) {
      throw new SimulationException("no camera '" + name + "' in this world");
    }
    camera = found;
    image = null;
    String variable = name + ".val";
    if (!variable.equals(imageVariable)) {
      imageVariable = variable;
      UNotifyChange(variable, "newImage");
    }
    ready(server).describe(setting());
  }

  /**
   * Marks what a detector finds in the images of the camera.
   *
   * @param name that of the UObject
   * @throws SimulationException if it is no BallDetector
   */
  public void showDetector(String name) {
    if (!(getUContext().getUObject(name) instanceof BallDetector found)) {
      throw new SimulationException("no BallDetector '" + name + "'");
    }
    detector = found;
  }

  /** A new image, perhaps of the camera that is shown. */
  public void newImage(UVar variable) {
    if (variable.getName().equals(imageVariable)) {
      image = variable.uimageValue();
      imageNumber++;
    }
  }

  /** Somebody wants to know how many are looking. */
  public void count() {
    viewers.setValue(ready(server).viewers());
  }

  /** Shows what there is now, if anybody looks. */
  void show() {
    PageServer present = ready(server);
    if (present.isWaiting()) {
      SimWorld shown = ready(simulation);
      Pace pace = shown.pace();
      present.show(
          Snapshot.of(shown.world(), new Snapshot.Clock(pace.isPaused(), pace.speed()), sight()));
    }
  }

  private Snapshot.@Nullable CameraView sight() {
    if (camera == null) {
      return null;
    }
    return new Snapshot.CameraView(
        camera.mount().worldPose(),
        image,
        imageNumber,
        detector != null,
        detector == null ? null : detector.last());
  }

  @Override
  public void close() {
    if (simulation != null) {
      simulation.remove(this);
    }
    if (server != null) {
      Annexes.of(getUContext()).remove(get__name());
      server.close();
    }
  }
}

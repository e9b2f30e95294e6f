package org.urbi.sim.device;

import static org.urbi.sim.SimulationException.ready;

import org.jspecify.annotations.Nullable;
import org.urbi.sim.SimulationException;
import org.urbi.sim.page.PageServer;
import org.urbi.sim.page.Snapshot;
import org.urbi.sim.page.WorldDescription;
import urbi.UImage;
import urbi.UObject;
import urbi.UStart;
import urbi.UVar;

/**
 * A page for browsers that shows a world while it goes on, {@code new(WORLD, PORT)}: the scene from
 * above, what a camera sees and a detector finds in it, and the drives with their targets. It is
 * for this machine alone unless {@code host} is another address. {@code port} and {@code host} can
 * be changed; {@code url} is what to give to a browser, {@code viewers} how many are looking.
 */
@UStart
public final class SimPage extends UObject implements AutoCloseable {
  private static final String THIS_MACHINE = "127.0.0.1";

  private final UVar port = new UVar();
  private final UVar host = new UVar();
  private final UVar url = new UVar();
  private final UVar viewers = new UVar();
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
    server = new PageServer(THIS_MACHINE, wanted, WorldDescription.of(found.world(), null));
    simulation = found;
    found.add(this);
    UBindVars(port, "port", host, "host", url, "url", viewers, "viewers");
    tellWhere();
    viewers.setValue(0);
    UNotifyChange(port, "moved");
    UNotifyChange(host, "moved");
    UNotifyAccess(viewers, "count");
    UBindFunctions("showCamera", "showDetector");
  }

  private void tellWhere() {
    PageServer present = ready(server);
    host.setValue(usedHost);
    port.setValue(present.port());
    url.setValue(present.url());
  }

  /** Another port or host; if these cannot be used it stays where it was. */
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
      server = new PageServer(newHost, newPort, setting());
      usedHost = newHost;
    } catch (SimulationException e) {
      server = new PageServer(usedHost, oldPort, setting());
      throw e;
    } finally {
      tellWhere();
    }
  }

  private String setting() {
    return WorldDescription.of(ready(simulation).world(), camera == null ? null : camera.mount());
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
      present.show(Snapshot.of(ready(simulation).world(), sight()));
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
      server.close();
    }
  }
}

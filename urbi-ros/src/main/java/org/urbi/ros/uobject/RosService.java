package org.urbi.ros.uobject;

import java.util.concurrent.CompletionStage;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.graph.ServiceClient;
import org.urbi.ros.message.Templates;
import urbi.UDictionary;
import urbi.UObject;
import urbi.UVar;

/** A service of another node that urbiscript calls (manual, "Ros.Service"). */
public final class RosService extends UObject implements AutoCloseable {
  static {
    UStart(RosService.class);
  }

  private final UVar initialized = new UVar();
  private final UVar seconds = new UVar();
  private final Patience patience;
  private volatile String service = "";
  private final Held<ServiceClient> held = new Held<>(ServiceClient::close);

  public RosService(String name) {
    super(name);
    UBindVars(initialized, "initialized", seconds, "patience");
    initialized.setValue(0);
    patience = new Patience(seconds);
    UBindFunctions("init", "name", "reqStruct", "resStruct", "request");
  }

  /**
   * Looks the service up. The job waits until it is there.
   *
   * @param keepAlive whether the connection is kept between requests
   */
  public CompletionStage<Void> init(String name, boolean keepAlive) {
    return held.hold(
        Ros.of(this)
            .thenCompose(node -> {
              service = node.resolve(name);
              return node.client(name, null, keepAlive);
            }),
        () -> initialized.setValue(1));
  }

  private ServiceClient client() {
    ServiceClient known = held.get();
    if (known == null) {
      throw new RosException(service + " is not initialized");
    }
    return known;
  }

  /** The full name of the service. */
  public String name() {
    return service;
  }

  /** A new request. */
  public UDictionary reqStruct() {
    return Templates.of(client().type().request());
  }

  /** A new response. */
  public UDictionary resStruct() {
    return Templates.of(client().type().response());
  }

  /**
   * Asks the service. The job waits for the answer, at most for the seconds of {@code patience}.
   */
  public CompletionStage<UDictionary> request(UDictionary request) {
    long most = patience.milliseconds();
    return Patience.within(most, service, client().request(request));
  }

  @Override
  public void close() {
    held.close();
  }
}

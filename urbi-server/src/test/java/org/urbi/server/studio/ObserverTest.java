package org.urbi.server.studio;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.observe.Steering;
import org.urbi.kernel.trust.Role;
import org.urbi.server.studio.files.Folders;
import org.urbi.server.trust.AccessPolicy;
import org.urbi.server.trust.Tokens;

/** What an observer gets who sends each kind of request, without the page and its buttons. */
class ObserverTest {
  private static final String TOKEN = "0123456789abcdef";
  private static final String REFUSED = "needs the role";
  private static final String NO_FILES = "the role observer has no files";

  /** Of what an observer may ask: it only looks. */
  private static final Set<Class<?>> LOOKING =
      Set.of(
          Request.Interest.class,
          Request.Reactions.class,
          Request.Variables.class,
          Request.Plot.class,
          Request.Show.class,
          Request.Check.class,
          Request.Complete.class);

  /** What an observer sends in vain, and what the refusal says. */
  private final Map<String, String> orders = new LinkedHashMap<>();

  @TempDir Path folder;

  private static void addKinds(Class<?> type, Set<String> kinds) {
    if (type.isRecord()) {
      kinds.add(type.getSimpleName());
    } else {
      for (Class<?> each : type.getPermittedSubclasses()) {
        addKinds(each, kinds);
      }
    }
  }

  private static String number(String view, String pattern) {
    String number = view.replaceFirst("(?s).*?" + pattern + ".*", "$1");
    assertTrue(number.matches("\\d+"), view);
    return number;
  }

  /** Everything that changes something, each with something that is there to be changed. */
  private void collect(String tag, String job, String event, String run) {
    for (Steering.Action action : Steering.Action.values()) {
      String name = action.name().toLowerCase(Locale.ROOT);
      for (String target : List.of("'tag','target':" + tag, "'job','target':" + job)) {
        orders.put("'type':'steer','action':'" + name + "','kind':" + target, REFUSED);
      }
    }
    for (String payload : List.of("", "Global.kept = 4")) {
      orders.put("'type':'emit','event':" + event + ",'payload':'" + payload + "'", REFUSED);
    }
    for (String value : List.of("5", "Global.kept = 6", "{ Global.kept = 7; 1 }")) {
      orders.put("'type':'assign','way':'Global\\n.kept','value':'" + value + "'", REFUSED);
    }
    orders.put("'type':'run','file':'x','code':'Global.kept = 8'", REFUSED);
    orders.put("'type':'stop','run':" + run, "");
    orders.put("'type':'files'", NO_FILES);
    orders.put("'type':'open','name':'walk.u'", NO_FILES);
    orders.put("'type':'save','name':'walk.u','text':'1','version':''", NO_FILES);
    orders.put("'type':'save','name':'new.u','text':'1','version':''", NO_FILES);
    orders.put("'type':'download','recording':1", "only an owner may download recordings");
  }

  @Test
  void eachKindOfRequestIsRefusedOrOnlyLooks() throws Exception {
    Files.writeString(folder.resolve("walk.u"), "walk;\n");
    Tokens tokens = Tokens.single(TOKEN, Role.OBSERVER, "visitor");
    try (Kernel kernel = Kernel.builder().log(line -> {}).start();
        StudioServer studio =
            Served.of(
                kernel,
                new AccessPolicy(tokens, Role.OWNER),
                Shown.VARIABLES,
                new Folders(folder, null));
        StreamClient owner = new StreamClient(studio, "/stream");
        StreamClient observer = new StreamClient(studio, "/stream?token=" + TOKEN)) {
      kernel.eval(
          "var Global.kept = 3| var Global.hits = 0| var Global.bell = Event.new()|"
              + "at (bell?) Global.hits++| kept_tag: detach(sleep(1h))|");
      owner.send("{\"type\":\"run\",\"id\":1,\"file\":\"own\",\"code\":\"sleep(1h)\"}");
      String run = number(owner.await("\"run\":"), "\"run\":(\\d+)");
      String view = observer.await("\"name\":\"kept_tag\"");
      observer.send("{\"type\":\"reactions\",\"filter\":\"\"}");
      String reactions = observer.await("\"events\":[{");
      collect(
          number(view, "\"number\":(\\d+),\"name\":\"kept_tag\""),
          number(view, "\"number\":(\\d+)[^{}]*\"lobby\":\"Lobby\""),
          number(reactions, "\"events\":\\[\\{\"number\":(\\d+)"),
          run);

      Set<String> kinds = new TreeSet<>();
      int id = 100;
      for (Map.Entry<String, String> order : orders.entrySet()) {
        String text = "{'id':" + ++id + "," + order.getKey() + "}";
        String json = text.replace('\'', '"');
        kinds.add(Request.read(json).getClass().getSimpleName());
        observer.send(json);
        String answer = observer.await("\"done\",\"id\":" + id + ",");
        assertTrue(answer.contains(order.getValue()), () -> text + ": " + answer);
        assertFalse(answer.contains("\"error\":\"\""), () -> text + ": " + answer);
      }
      assertEquals(3.0, kernel.eval("Global.kept"));
      assertEquals(0.0, kernel.eval("Global.hits"));
      assertEquals(false, kernel.eval("kept_tag.frozen || kept_tag.blocked"));
      assertEquals("walk;\n", Files.readString(folder.resolve("walk.u")));
      assertFalse(Files.exists(folder.resolve("new.u")));
      assertTrue(
          owner.heard.stream().noneMatch(each -> each.contains("\"id\":1,")),
          "what the owner runs goes on");

      LOOKING.forEach(each -> kinds.add(each.getSimpleName()));
      Set<String> all = new TreeSet<>();
      addKinds(Request.class, all);
      assertEquals(all, kinds, "each kind of request is either looking, or tried here");
    }
  }

  @Test
  void lookingChangesNothing() throws Exception {
    Tokens tokens = Tokens.single(TOKEN, Role.OBSERVER, "visitor");
    try (Kernel kernel = Kernel.builder().log(line -> {}).start();
        StudioServer studio =
            Served.of(
                kernel,
                new AccessPolicy(tokens, null),
                Shown.VARIABLES,
                new Folders(folder, null));
        StreamClient observer = new StreamClient(studio, "/stream?token=" + TOKEN)) {
      kernel.eval("var Global.kept = 3|");
      for (String looking :
          List.of(
              "'type':'complete','text':'{ Global.kept = 4 }.'",
              "'type':'complete','text':'Global.kept = 4; Global.k'",
              "'type':'check','code':'Global.kept = 4'",
              "'type':'show','way':'Global\\n.kept = 4'",
              "'type':'plot','ways':['Global\\n.kept = 4']",
              "'type':'variables','objects':['Global.kept = 4']",
              "'type':'reactions','filter':'Global.kept = 4'",
              "'type':'interest','selected':99999,'traced':[99999]")) {
        observer.send(("{'id':1," + looking + "}").replace('\'', '"'));
      }
      observer.send("{\"type\":\"check\",\"id\":2,\"code\":\"1\"}");
      observer.await("\"id\":2,");
      assertEquals(3.0, kernel.eval("Global.kept"));
    }
  }
}

package org.urbi.kernel.script;

import java.util.List;
import javax.script.ScriptEngine;
import javax.script.ScriptEngineFactory;
import org.jspecify.annotations.Nullable;

/** Makes {@code urbiscript} known to {@link javax.script.ScriptEngineManager}. */
public final class UrbiScriptEngineFactory implements ScriptEngineFactory {
  private static final String NAME = "urbiscript";

  @Override
  public String getEngineName() {
    return "Urbi on the JVM";
  }

  @Override
  public String getEngineVersion() {
    String version = getClass().getPackage().getImplementationVersion();
    return version == null ? "3" : version;
  }

  @Override
  public List<String> getExtensions() {
    return List.of("u");
  }

  @Override
  public List<String> getMimeTypes() {
    return List.of("text/x-urbiscript");
  }

  @Override
  public List<String> getNames() {
    return List.of(NAME, "urbi");
  }

  @Override
  public String getLanguageName() {
    return NAME;
  }

  @Override
  public String getLanguageVersion() {
    return "2.7";
  }

  @Override
  public @Nullable Object getParameter(String key) {
    return switch (key) {
      case ScriptEngine.ENGINE -> getEngineName();
      case ScriptEngine.ENGINE_VERSION -> getEngineVersion();
      case ScriptEngine.LANGUAGE -> getLanguageName();
      case ScriptEngine.LANGUAGE_VERSION -> getLanguageVersion();
      case ScriptEngine.NAME -> NAME;
      case "THREADING" -> "MULTITHREADED";
      default -> null;
    };
  }

  @Override
  public String getMethodCallSyntax(String target, String method, String... arguments) {
    return target + "." + method + "(" + String.join(", ", arguments) + ")";
  }

  @Override
  public String getOutputStatement(String text) {
    StringBuilder literal = new StringBuilder("echo(\"");
    for (char c : text.toCharArray()) {
      switch (c) {
        case '"', '\\' -> literal.append('\\').append(c);
        case '\n' -> literal.append("\\n");
        default -> literal.append(c);
      }
    }
    return literal.append("\")").toString();
  }

  @Override
  public String getProgram(String... statements) {
    return String.join(";\n", statements) + ";\n";
  }

  @Override
  public UrbiScriptEngine getScriptEngine() {
    return new UrbiScriptEngine(this);
  }
}

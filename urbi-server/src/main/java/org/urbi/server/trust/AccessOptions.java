package org.urbi.server.trust;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.trust.Role;
import org.urbi.server.options.Arguments;
import org.urbi.server.options.Failure;
import org.urbi.server.options.Program;

/**
 * The options of {@code urbi} for access control: which clients are accepted, with which roles.
 *
 * @param accessPolicy of clients of the network
 * @param userDirectory where users have files; null when they have none
 * @param insecure whether other machines are let in without a token
 */
public record AccessOptions(
    AccessPolicy accessPolicy, @Nullable Path userDirectory, boolean insecure) {
  private static final String NOBODY = "none";

  /** Adds the options to a program. */
  public static Program declare(Program program) {
    return program
        .option("FILE", "Ask clients for one of the tokens in FILE.", "--tokens")
        .option(
            "ROLE",
            "What clients without a token may do: owner, user, observer, or none (the default):"
                + " they are not let in.",
            "--default-role")
        .option("DIRECTORY", "Where clients with the role user have files.", "--user-directory")
        .option(
            "FILE",
            "Speak TLS alone, and show the certificate in FILE (PEM); bin/urbi-certificate makes"
                + " one.",
            "--tls-certificate")
        .option("FILE", "The private key of the certificate (PEM).", "--tls-key")
        .flag("Let other machines in without a token.", "--insecure");
  }

  /**
   * What the options say.
   *
   * @throws Failure if they make no sense, or a file is not as it must be
   */
  public static AccessOptions of(Arguments arguments) {
    String tokens = arguments.value("--tokens");
    if (tokens == null && arguments.has("--default-role")) {
      throw Failure.usage("--default-role is for clients without a token: it needs --tokens");
    }
    String directory = arguments.value("--user-directory");
    if (directory != null && !Files.isDirectory(Path.of(directory))) {
      throw Failure.of("--user-directory: no such directory: " + directory);
    }
    ServerIdentity identity = identity(arguments);
    return new AccessOptions(
        tokens == null
            ? new AccessPolicy(null, Role.OWNER, identity)
            : new AccessPolicy(
                read(Path.of(tokens)),
                defaultRole(arguments.value("--default-role", NOBODY)),
                identity),
        directory == null ? null : Path.of(directory),
        arguments.has("--insecure"));
  }

  private static @Nullable Role defaultRole(String name) {
    Role role = Role.of(name);
    if (role == null && !name.equals(NOBODY)) {
      throw Failure.usage("--default-role is owner, user, observer or none, not " + name);
    }
    return role;
  }

  private static @Nullable ServerIdentity identity(Arguments arguments) {
    String certificate = arguments.value("--tls-certificate");
    String key = arguments.value("--tls-key");
    if (certificate == null && key == null) {
      return null;
    }
    if (certificate == null || key == null) {
      throw Failure.usage("TLS needs both --tls-certificate and --tls-key");
    }
    try {
      return ServerIdentity.read(Path.of(certificate), Path.of(key));
    } catch (IOException e) {
      throw Failure.of("cannot use TLS: " + e.getMessage());
    }
  }

  private static Tokens read(Path file) {
    try {
      return Tokens.read(file);
    } catch (IOException e) {
      throw Failure.of("cannot use the tokens: " + e.getMessage());
    }
  }

  /** What is to be told about the files of TLS. */
  public List<String> warnings() {
    ServerIdentity identity = accessPolicy.identity();
    return identity == null ? List.of() : identity.warnings();
  }

  /**
   * Refuses to accept other machines without tokens, unless {@code --insecure} allows it.
   *
   * @return a warning; null when nothing is to be feared
   * @throws Failure if it is not wanted
   */
  public @Nullable String checkAddress(InetSocketAddress address) {
    if (address.getAddress().isLoopbackAddress() || accessPolicy.asks()) {
      return null;
    }
    if (!insecure) {
      throw Failure.usage(
          "--host "
              + address.getHostString()
              + " lets every machine that reaches it do everything: give --tokens FILE, or"
              + " --insecure");
    }
    return "other machines are let in without a token, and may do everything";
  }
}

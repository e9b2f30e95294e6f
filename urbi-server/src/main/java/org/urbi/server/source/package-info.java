/** Text on its way to a lobby: from options, files and modules. */
package org.urbi.server.source;

/** The engine as the rest of the world sees it: kernels, connections, embedding. */
package org.urbi.kernel;

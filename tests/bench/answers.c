/* The floor of showing: writes the same bytes and nothing else.
 *
 * answers FILE WATCHERS: prints its port. WATCHERS 0: answers every HTTP request with the file's bytes. Otherwise waits for so many
 * connections and writes the file's bytes to each, ten times a second.
 */
#include "wire.h"

#include <sys/stat.h>

static char *bytes;
static size_t size;

static void send_all(int fd) {
    for (size_t at = 0; at < size;) {
        ssize_t sent = send(fd, bytes + at, size - at, MSG_NOSIGNAL);
        if (sent < 0) exit(0);
        at += (size_t)sent;
    }
}

int main(int argc, char **argv) {
    if (argc != 3) return 2;
    FILE *file = fopen(argv[1], "rb");
    struct stat about;
    if (!file || stat(argv[1], &about)) die(argv[1]);
    size = (size_t)about.st_size;
    bytes = malloc(size);
    if (fread(bytes, 1, size, file) != size) die(argv[1]);
    int watchers = atoi(argv[2]), listener = socket(AF_INET, SOCK_STREAM, 0), epoll = epoll_create1(0), one = 1;
    struct sockaddr_in address = loopback(0);
    socklen_t length = sizeof address;
    if (bind(listener, (struct sockaddr *)&address, length) || listen(listener, 4096)) die("listen");
    getsockname(listener, (struct sockaddr *)&address, &length);
    printf("%d\n", ntohs(address.sin_port));
    fflush(stdout);
    if (watchers) {
        int *fds = calloc((size_t)watchers, sizeof *fds), clock = timerfd_create(CLOCK_MONOTONIC, 0);
        for (int i = 0; i < watchers; i++) fds[i] = accept(listener, NULL, NULL);
        struct itimerspec tenth = {{0, 100000000}, {0, 100000000}};
        timerfd_settime(clock, 0, &tenth, NULL);
        for (uint64_t ticks; read(clock, &ticks, sizeof ticks) > 0;)
            for (int i = 0; i < watchers; i++) send_all(fds[i]);
    }
    struct epoll_event events[256];
    watch(epoll, listener, NULL);
    for (;;) {
        int ready = epoll_wait(epoll, events, 256, -1);
        for (int i = 0; i < ready; i++) {
            int *known = events[i].data.ptr;
            if (!known) {
                int *fd = malloc(sizeof *fd);
                *fd = accept(listener, NULL, NULL);
                setsockopt(*fd, IPPROTO_TCP, TCP_NODELAY, &one, sizeof one);
                watch(epoll, *fd, fd);
                continue;
            }
            char request[4096];
            if (recv(*known, request, sizeof request, 0) <= 0) {
                close(*known);
                free(known);
            } else {
                send_all(*known);
            }
        }
    }
}

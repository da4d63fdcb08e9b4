/* The little of iTSC that the two C programs of the benchmark need (PROTOCOLS 1.3, 1.7): sizes, offsets, CRC, sockets. */
#pragma once
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/epoll.h>
#include <sys/socket.h>
#include <sys/timerfd.h>
#include <time.h>
#include <unistd.h>

enum { ENQ = 0x05, ACK = 0x06, ENQ_SIZE = 33, ACK_SIZE = 15, IDS = 12, CODE_AT = 13, BODY_AT = 15, STATUS = 0x7030 };

static uint16_t crc_table[256];

static void crc_init(void) {
    for (int i = 0; i < 256; i++) {
        uint16_t crc = (uint16_t)(i << 8);
        for (int bit = 0; bit < 8; bit++) crc = (uint16_t)(crc & 0x8000 ? crc << 1 ^ 0x1021 : crc << 1);
        crc_table[i] = crc;
    }
}

static inline uint16_t crc16(const uint8_t *data, int size) {
    uint16_t crc = 0xFFFF;
    for (int i = 0; i < size; i++) crc = (uint16_t)(crc << 8 ^ crc_table[(crc >> 8 ^ data[i]) & 0xFF]);
    return crc;
}

static inline uint64_t get(const uint8_t *at, int size) {
    uint64_t value = 0;
    for (int i = 0; i < size; i++) value = value << 8 | at[i];
    return value;
}

static inline void put(uint8_t *at, int size, uint64_t value) {
    while (size--) {
        at[size] = (uint8_t)value;
        value >>= 8;
    }
}

static inline void seal(uint8_t *packet, int size) { put(packet + size - 2, 2, crc16(packet, size - 2)); }

static inline int sound(const uint8_t *packet, int size) {
    return crc16(packet, size - 2) == (uint16_t)get(packet + size - 2, 2);
}

static void die(const char *what) {
    perror(what);
    exit(1);
}

static void tune(int fd) {
    int one = 1;
    if (setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &one, sizeof one)) die("TCP_NODELAY");
    if (fcntl(fd, F_SETFL, O_NONBLOCK)) die("O_NONBLOCK");
}

static struct sockaddr_in loopback(int port) {
    struct sockaddr_in address = {.sin_family = AF_INET, .sin_port = htons((uint16_t)port)};
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return address;
}

static double seconds(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + (double)t.tv_nsec * 1e-9;
}

static void watch(int epoll, int fd, void *mark) {
    struct epoll_event event = {.events = EPOLLIN, .data.ptr = mark};
    if (epoll_ctl(epoll, EPOLL_CTL_ADD, fd, &event)) die("epoll_ctl");
}
